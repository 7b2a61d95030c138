#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <map>
#include <set>
#include <sstream>

#include "engine/files/files.h"
#include "engine/files/obj.h"
#include "engine/files/png.h"
#include "tests/support/folders.h"
#include "tools/demo_level/art/textures.h"
#include "tools/demo_level/map/museum.h"
#include "tools/demo_level/models/models.h"
#include "tools/texture/texture_files.h"

namespace oblong {
namespace {

const std::filesystem::path kTextures = std::filesystem::path(test::source_folder()) / "assets" / "textures";

std::string museum_text() {
    std::ostringstream text;
    map_source::write_map(map_source::make_museum(), text);
    return text.str();
}

template <class Visit>
void for_each_face(const map_source::Draft& museum, Visit visit) {
    for (const auto& entity : museum.entities()) {
        for (const auto& brush : entity.brushes) {
            for (const auto& face : brush.faces) visit(face);
        }
    }
}

TEST(DemoSource, IsTheSameEveryTime) {
    EXPECT_EQ(museum_text(), museum_text());
}

TEST(DemoSource, EveryCoordinateIsExactInAFloatAndInTheFormatsRange) {
    // Below 4,096 a float's 24 bits leave 12 after the point, as many as the world's format has.
    for_each_face(map_source::make_museum(), [](const map_source::BrushFace& face) {
        for (const auto& point : face.points) {
            for (const double value : {point.x, point.y, point.z}) {
                EXPECT_EQ(value * 4096, std::floor(value * 4096));
                EXPECT_LT(std::abs(value), 4096);
            }
        }
    });
}

TEST(DemoSource, NamesOnlyTexturesThatThereAre) {
    std::set<std::string> names;
    for_each_face(map_source::make_museum(),
                  [&](const map_source::BrushFace& face) { names.insert(face.placement.texture); });
    EXPECT_GT(names.size(), 40u);
    for (const std::string& name : names) {
        EXPECT_TRUE(std::filesystem::exists(kTextures / file_of_texture_name(name))) << name;
    }
}

double distance_between(const map_source::Point& a, const map_source::Point& b) {
    return std::hypot(a.x - b.x, a.y - b.y, a.z - b.z);
}

/// Whether a light that stands at most 16 units before the body has all of it within its radius.
bool is_free_of(const map_source::Brush& body, const map_source::MapEntity& light) {
    std::map<std::string, std::string> keys(light.pairs.begin(), light.pairs.end());
    map_source::Point at;
    if (keys["radius"].empty() || std::sscanf(keys["origin"].c_str(), "%lf %lf %lf", &at.x, &at.y, &at.z) != 3)
        return false;
    double nearest = 1e9, farthest = 0;
    for (const auto& face : body.faces)
        for (const auto& corner : face.points) {
            nearest = std::min(nearest, distance_between(corner, at));
            farthest = std::max(farthest, distance_between(corner, at));
        }
    return nearest < 16 && farthest < std::stod(keys["radius"]);
}

TEST(DemoSource, NoLampDarkensTheWallAroundItByItsOwnShadow) {
    const auto museum = map_source::make_museum();
    int lamps = 0;
    for (const auto& entity : museum.entities())
        for (const auto& brush : entity.brushes) {
            if (brush.faces[0].placement.texture != "lamp") continue;
            ++lamps;
            const auto& corner = brush.faces[0].points[0];
            EXPECT_TRUE(
                std::ranges::any_of(museum.entities(), [&](const auto& light) { return is_free_of(brush, light); }))
                << "at " << corner.x << ' ' << corner.y << ' ' << corner.z;
        }
    EXPECT_GT(lamps, 30);
}

/// How far a point is in front of a face's plane, in units of the length of its normal.
double height_over(const map_source::BrushFace& face, const map_source::Point& point) {
    const auto normal = map_source::outward_normal(face);
    const auto& on_plane = face.points[0];
    return normal.x * (point.x - on_plane.x) + normal.y * (point.y - on_plane.y) + normal.z * (point.z - on_plane.z);
}

bool is_convex(const map_source::Brush& brush) {
    for (const auto& face : brush.faces) {
        for (const auto& other : brush.faces) {
            for (const auto& point : other.points) {
                if (height_over(face, point) > 0) return false;
            }
        }
    }
    return true;
}

TEST(DemoSource, EveryBrushIsConvexExactly) {
    const auto museum = map_source::make_museum();
    for (const auto& entity : museum.entities()) {
        for (const auto& brush : entity.brushes) {
            const auto& corner = brush.faces[0].points[0];
            EXPECT_TRUE(is_convex(brush)) << "at " << corner.x << ' ' << corner.y << ' ' << corner.z;
        }
    }
}

TEST(DemoTextures, TheCommittedPicturesAreWhatThePaintersPaint) {
    std::size_t count = 0;
    for (const auto& [name, canvas] : art::paint_all_textures()) {
        const PngImage decoded = decode_png(read_file((kTextures / (name + ".png")).string()));
        EXPECT_EQ(decoded.indices, canvas.to_indices())
            << name << ": run oblong-demo-level textures -o assets/textures";
        EXPECT_TRUE(std::ranges::equal(decoded.colours, art::design_palette().colours, {}, &Rgba8::colour)) << name;
        ++count;
    }
    const auto files = std::distance(std::filesystem::directory_iterator(kTextures), {});
    EXPECT_EQ(static_cast<std::ptrdiff_t>(count), files);
}

TEST(DemoModels, TheCommittedFilesAreWhatIsMade) {
    const std::filesystem::path models = kTextures.parent_path() / "models";
    const std::string how = ": run oblong-demo-level models -o assets/models";
    std::size_t count = 0;
    for (const auto& [name, text] : model_source::all_model_files()) {
        EXPECT_EQ(read_text((models / name).string()), text) << name << how;
        ++count;
    }
    for (const auto& [name, canvas] : model_source::paint_all_skins()) {
        const PngImage decoded = decode_png(read_file((models / (name + ".png")).string()));
        EXPECT_EQ(decoded.indices, canvas.to_indices()) << name << how;
        ++count;
    }
    EXPECT_EQ(static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(models), {})), count);
}

TEST(DemoModels, EachIsReadWithoutAWarning) {
    for (const auto& [name, text] : model_source::all_model_files()) {
        if (!name.ends_with(".obj")) continue;
        const ObjModel model = read_obj((kTextures.parent_path() / "models" / name).string(), art::design_palette());
        EXPECT_TRUE(model.warnings.empty()) << name;
        EXPECT_FALSE(model.mesh.triangles.empty()) << name;
    }
}

TEST(DemoModels, TheArmillarySphereIsReadWithoutAWarning) {
    const ObjModel model =
        read_obj((kTextures.parent_path() / "models" / "armillary.obj").string(), art::design_palette());
    EXPECT_TRUE(model.warnings.empty());
    EXPECT_EQ(model.mesh.skins.size(), 3u);
    EXPECT_EQ(model.mesh.frames[0].mins.z, World{}) << "it stands on its foot";
    EXPECT_NEAR(model.mesh.frames[0].maxs.z.raw / 4096.0, 3.05, 0.01);
}

art::Canvas painted(const std::string& name) {
    for (auto& texture : art::paint_all_textures()) {
        if (texture.name == name) return texture.canvas;
    }
    ADD_FAILURE() << "no texture " << name;
    return {16, 16};
}

/// The largest difference of brightness between column x and the one left of it (the last one, for 0).
int largest_step(const art::Canvas& canvas, int x) {
    int largest = 0;
    for (int y = 0; y < canvas.height(); ++y) {
        largest = std::max(largest, std::abs(canvas.at(x, y).level - canvas.at(x - 1, y).level));
    }
    return largest;
}

TEST(DemoTextures, WhatHasNoJointsTilesWithoutASeam) {
    for (const char* name : {"marble_ivory", "#water", "earth"}) {
        const art::Canvas canvas = painted(name);
        int largest_inside = 0;
        for (int x = 1; x < canvas.width(); ++x) largest_inside = std::max(largest_inside, largest_step(canvas, x));
        EXPECT_LE(largest_step(canvas, 0), largest_inside) << name;
    }
}

}  // namespace
}  // namespace oblong
