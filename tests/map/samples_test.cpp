#include <gtest/gtest.h>

#include <cmath>

#include "engine/level/bsp_read.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"

namespace oblong::test {
namespace {

// How many samples a reader of the file counts in a face's lightmap, which keeps texels in floats.
int samples_of(const map::BspFile& bsp, const map::FileFace& face) {
    int count = 1;
    for (const auto& axis : bsp.texinfos.at(static_cast<std::size_t>(face.texinfo)).axes) {
        float low = 1e9F, high = -1e9F;
        for (const Point& p : corners_of(bsp, face)) {
            const auto [x, y, z] = axis.direction;
            const double sum = double{x} * p.x + double{y} * p.y + double{z} * p.z + double{axis.offset};
            low = std::min(low, static_cast<float>(sum));
            high = std::max(high, static_cast<float>(sum));
        }
        count *= static_cast<int>(std::ceil(high / 16) - std::floor(low / 16)) + 1;
    }
    return count;
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

}  // namespace
}  // namespace oblong::test
