#include <gtest/gtest.h>

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "tests/demo/visitor.h"
#include "tests/support/folders.h"

namespace oblong::test::walk_test {
namespace {

class DemoWalk : public testing::Test {
  protected:
    void walk(const std::vector<test::Waypoint>& route) { visitor_.walk(route); }

    const Level level_ = read_bsp(read_file(test::build_folder() + "/assets/demo.bsp"));
    test::Visitor visitor_{level_};
};

const std::vector<test::Waypoint> kEntranceToGallery{{0, -16}, {0, 200}, {200, 416}, {400, 416}};
const std::vector<test::Waypoint> kCourtyardToTower{
    {512, 1420},  {-60, 1600},  {-200, 1600}, {-290, 1590}, {-500, 1584}, {-720, 1584}, {-792, 1620},
    {-792, 2128}, {-792, 2320}, {-80, 2320},  {512, 2320},  {512, 2200},  {512, 1900}};

TEST_F(DemoWalk, TheTowerIsShutAtBothGatesWhileLensesAreMissing) {
    walk(kEntranceToGallery);
    walk({{736, 416}, {736, 560}, {512, 760}, {512, 1160}, {512, 1360}, {512, 1540}});
    EXPECT_FALSE(visitor_.walk_to({512, 1640})) << "from the courtyard";
    walk({{512, 1420}});
    walk(kCourtyardToTower);
    EXPECT_FALSE(visitor_.walk_to({512, 1800})) << "from the corridor";
}

}  // namespace
}  // namespace oblong::test::walk_test
