#include <gtest/gtest.h>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "tests/map/bsp_checks.h"
#include "tests/map/map_source.h"
#include "tests/support/shared_levels.h"

namespace oblong::test {
namespace {

map::BspFile compile_shared(const std::string& name) {
    const auto folder = find_shared_folder() / "levels";
    std::vector<map::Wad> wads;
    for (const char* wad : {"gfx/metal.wad", "gfx/wizard.wad"}) wads.emplace_back(read_text((folder / wad).string()));
    return map::compile_map(map::parse_map(read_text((folder / (name + ".map")).string())), wads, {true});
}

TEST(RealSources, AreSealedAndReadable) {
    OBLONG_NEEDS_SHARED_LEVELS();
    for (const std::string name : kRealLevels) {
        const auto bsp = compile_shared(name);
        EXPECT_EQ(open_edges(bsp), 0) << name;
        EXPECT_EQ(first_fault_of_rays(bsp, 1500, 7), "") << name;
        const std::string bytes = map::to_bytes(bsp);
        const Level level = read_bsp({reinterpret_cast<const std::uint8_t*>(bytes.data()), bytes.size()});
        EXPECT_EQ(level.models.size(), bsp.models.size()) << name;
        EXPECT_EQ(map::to_bytes(compile_shared(name)), bytes) << name << ": the same bytes each time";
    }
}

}  // namespace
}  // namespace oblong::test
