#include <gtest/gtest.h>

#include <cmath>

#include "engine/level/bsp_read.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tools/map/tree/surfaces.h"

namespace oblong::test {
namespace {

// How many samples a reader of the file counts along each axis of a face's lightmap; it keeps texels in floats.
std::array<int, 2> sides_of(const map::BspFile& bsp, const map::FileFace& face) {
    std::array<int, 2> sides{};
    for (std::size_t i = 0; i < 2; ++i) {
        const auto& axis = bsp.texinfos.at(static_cast<std::size_t>(face.texinfo)).axes[i];
        float low = 1e9F, high = -1e9F;
        for (const Point& p : corners_of(bsp, face)) {
            const auto [x, y, z] = axis.direction;
            const double sum = double{x} * p.x + double{y} * p.y + double{z} * p.z + double{axis.offset};
            low = std::min(low, static_cast<float>(sum));
            high = std::max(high, static_cast<float>(sum));
        }
        sides[i] = static_cast<int>(std::ceil(high / 16) - std::floor(low / 16)) + 1;
    }
    return sides;
}

int samples_of(const map::BspFile& bsp, const map::FileFace& face) {
    const auto [width, height] = sides_of(bsp, face);
    return width * height;
}

// Axes that an editor turned: as doubles, corners at 16 and 256 texels lie a hair beyond the border of a sample.
TEST(Samples, PartsOfAxesThatNoFloatSeesAddNoSamples) {
    const std::string tail = "wall [ 1 6.123e-17 0 0 ] [ 6.123e-17 -1 6.123e-17 0 ] 0 1 1";
    const std::string turned = replaced(room({16, 16, 0}, {256, 256, 96}), "wall 0 0 0 1 1", tail);
    const auto bsp = compile(level(turned, entity_at("light", {136, 136, 64}, {{"light", "900"}})), {true});
    std::size_t sample_count = 0;
    int full_faces = 0;
    for (const auto& face : bsp.faces) {
        ASSERT_EQ(face.light_offset, static_cast<int>(sample_count)) << "lightmaps follow each other";
        sample_count += static_cast<std::size_t>(samples_of(bsp, face));
        full_faces += samples_of(bsp, face) == 16 * 16 ? 1 : 0;
    }
    EXPECT_EQ(sample_count, bsp.lighting.size());
    EXPECT_EQ(full_faces, 2) << "floor and ceiling of 240 by 240 texels";
}

// 16 is what engines have room for; a face of fewer than 16 beside one that goes on has been cut too soon.
TEST(Samples, LargeSurfacesAreCutIntoFacesOfSixteenSamplesAndNoMore) {
    for (const char* tail :
         {"0 0 0 1 1", "5 -7 0 1 1", "3 0 0 0.5 0.75", "0 0 30 1 1", "0 9 45 2 1", "0 0 0 0.3 1.1"}) {
        const std::string large =
            replaced(room({0, 0, 0}, {1200, 1000, 700}), "wall 0 0 0 1 1", std::string("wall ") + tail);
        const auto bsp = compile(level(large), {true});
        int widest = 0, highest = 0;
        for (const auto& face : bsp.faces) {
            const auto [width, height] = sides_of(bsp, face);
            widest = std::max(widest, width);
            highest = std::max(highest, height);
        }
        EXPECT_EQ(widest, 16) << tail;
        EXPECT_EQ(highest, 16) << tail;
    }
}

// 267 x 267 pieces of 240 texels.
TEST(Samples, MoreFacesThanVersion29HoldsAreCutForBsp2) {
    map::TexInfo texinfo;
    texinfo.axes = {Point{64, 0, 0}, Point{0, 64, 0}};
    const map::Surface square{0, {}, 0, {{0, 0, 0}, {0, 1000, 0}, {1000, 1000, 0}, {1000, 0, 0}}};
    EXPECT_EQ(map::subdivided({square}, {texinfo}).size(), 71289u);
    texinfo.axes = {Point{250, 0, 0}, Point{0, 250, 0}};
    EXPECT_THROW(map::subdivided({square}, {texinfo}), InputError) << "1042 x 1042 pieces";
}

}  // namespace
}  // namespace oblong::test
