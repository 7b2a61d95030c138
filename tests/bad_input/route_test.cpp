#include "tests/bad_input/run_program.h"

// oblong --route against routes that it must refuse.
namespace oblong::test {
namespace {

const std::string kHeader = "x,y,z,speed,wait,yaw,pitch,jump\n";

class BadRoute : public testing::Test {
  protected:
    Outcome walk(const std::string& route) {
        file_ = folder_.write("route.csv", route);
        return run_program({"oblong", "--route", file_, "--record", folder_.path("walk.demo")});
    }
    TemporaryFolder folder_;
    std::string file_;
};

TEST_F(BadRoute, AWalkIntoAWallIsStuckAndLeavesNoDemo) {
    const Outcome outcome = walk(kHeader + "0,-300,,,,,,\n400,-300,,,,,,\n");
    EXPECT_TRUE(names_fault(outcome, "oblong", file_, "line 3: stuck at 143 -301 24, expected to reach 400 -300"))
        << outcome.error;
    EXPECT_FALSE(std::filesystem::exists(folder_.path("walk.demo")));
}

TEST_F(BadRoute, WhatIsNoRoute) {
    EXPECT_TRUE(names_fault(walk("where to?\n"), "oblong", file_, "line 1: 'where to?', expected x,y,z"));
    const Outcome alone = run_program({"oblong", "--route", file_});
    EXPECT_EQ(alone.exit_code, 2) << "nothing to record into: " << alone.error;
}

}  // namespace
}  // namespace oblong::test
