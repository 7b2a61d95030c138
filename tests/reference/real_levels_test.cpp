#include <gtest/gtest.h>

#include "engine/accuracy/accuracy.h"
#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/level/bsp_read.h"
#include "engine/reference/frame.h"
#include "engine/scene/placed_models.h"
#include "engine/visibility/eye.h"
#include "tests/support/folders.h"
#include "tests/support/palettes.h"
#include "tests/support/point.h"
#include "tools/render/camera_list.h"

namespace oblong {
namespace {

/// A real level as both read it, seen from the eyes that the engine draws from: clear of all planes.
struct RealLevel {
    explicit RealLevel(const std::string& name)
        : bytes(test::read_shared_file(name + ".bsp")),
          level(read_bsp(bytes)),
          true_level(reference::read_level(bytes)),
          models(models_at_rest(level)) {
        for (const PlacedModel& placed : models) true_models.push_back({placed.model.number(), {}});
        const auto csv = test::read_shared_file("cameras/" + name + ".csv");
        const std::vector<Camera> all = parse_cameras(csv, Degrees::from_int(90));
        for (std::size_t i = 0; i < all.size(); i += 99) {
            cameras.push_back(all[i]);
            cameras.back().eye = place_eye(level, all[i].eye).position;
        }
    }

    std::vector<std::uint8_t> bytes;
    Level level;
    reference::Level true_level;
    std::vector<PlacedModel> models;
    std::vector<reference::PlacedModel> true_models;
    std::vector<Camera> cameras;
};

reference::View view_of(const Camera& camera) {
    reference::View view;
    view.eye = test::to_point(camera.eye);
    view.yaw = camera.yaw.bam;
    view.pitch = camera.pitch.bam;
    view.roll = camera.roll.bam;
    return view;
}

TEST(ReferenceRealLevels, AreReadAsTheEngineReadsThem) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const char* name : test::kRealLevels) {
        const RealLevel real(name);
        ASSERT_EQ(real.true_level.faces.size(), real.level.faces.size());
        for (std::size_t i = 0; i < real.level.faces.size(); ++i) {
            const Face& engine = real.level.faces[FaceIndex(static_cast<std::int32_t>(i))];
            const reference::Face& face = real.true_level.faces[i];
            ASSERT_EQ(face.first_u, engine.texel_min_u) << name << ' ' << i;
            ASSERT_EQ(face.first_v, engine.texel_min_v) << name << ' ' << i;
            ASSERT_EQ((face.light_columns - 1) * 16, engine.texel_extent_u) << name << ' ' << i;
            ASSERT_EQ((face.light_rows - 1) * 16, engine.texel_extent_v) << name << ' ' << i;
            ASSERT_EQ(face.light_offset, engine.light_offset) << name << ' ' << i;
            ASSERT_EQ(static_cast<int>(face.material), static_cast<int>(real.level.texinfos[engine.texinfo].material));
            ASSERT_EQ(real.true_level.texture_of(face).texels, real.level.texture_of(engine).mips[0])
                << name << ' ' << i;
        }
    }
}

/// Whether a face shows a palette index within 1/100 texel of a place.
bool shows_nearby(const reference::Texture& texture, double u, double v, std::uint8_t index) {
    const auto wrapped = [](double texel, int size) {
        const int rest = static_cast<int>(std::floor(texel)) % size;
        return rest < 0 ? rest + size : rest;
    };
    for (const double du : {-0.01, 0.0, 0.01})
        for (const double dv : {-0.01, 0.0, 0.01}) {
            const int at = wrapped(v + dv, texture.height) * texture.width + wrapped(u + du, texture.width);
            if (texture.texels[static_cast<std::size_t>(at)] == index) return true;
        }
    return false;
}

TEST(ReferenceRealLevels, TheExactPresetShowsTheReferencesTexels) {
    OBLONG_NEEDS_SHARED_LEVELS();
    const Colormap colormap = test::unshaded();
    const ScreenMode mode;
    Settings settings;
    settings.accuracy = accuracy_of(Preset::Exact);
    settings.accuracy.mip = MipSelection::None;
    settings.allowed_effects = kStillEffects;
    std::vector<std::uint8_t> picture(pixel_count(mode.width_px, mode.height_px));
    for (const char* name : test::kRealLevels) {
        const RealLevel real(name);
        FrameWorkspace work(real.level, mode);
        int compared = 0, different = 0;
        for (const Camera& camera : real.cameras) {
            draw_frame({real.level, colormap, real.models}, camera, mode, settings, work,
                       {picture.data(), 320, 200, 320});
            const reference::Frame frame =
                reference::draw_with_close_calls(real.true_level, real.true_models, view_of(camera));
            for (std::size_t i = 0; i < picture.size(); ++i) {
                const reference::Pixel& pixel = frame.pixels[i];
                const reference::Face& face = real.true_level.face(pixel.face);
                if (face.material != reference::Material::Lit || pixel.is_close_call) continue;
                ++compared;
                different += !shows_nearby(real.true_level.texture_of(face), pixel.u, pixel.v, picture[i]);
            }
        }
        EXPECT_EQ(different, 0) << name;
        EXPECT_GT(compared, 100000) << name;
    }
}

}  // namespace
}  // namespace oblong
