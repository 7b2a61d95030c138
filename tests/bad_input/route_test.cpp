#include "tests/support/programs.h"

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

TEST_F(BadRoute, AByteOrderMarkIsNoPartOfTheHeader) {
    EXPECT_TRUE(names_fault(walk("\xef\xbb\xbf" + kHeader + "here\n"), "oblong", file_, "line 2: "));
}

TEST_F(BadRoute, ThousandsOfUnknownArgumentsAreAShortMessage) {
    std::vector<std::string> arguments{"oblong-map"};
    for (int i = 0; i < 5000; ++i) arguments.push_back("--n" + std::to_string(i));
    const Outcome outcome = run_program(arguments);
    EXPECT_EQ(outcome.exit_code, 2);
    EXPECT_LT(outcome.error.size(), 1200u) << outcome.error.size();
    EXPECT_NE(outcome.error.find("--n"), std::string::npos) << outcome.error;
}

TEST_F(BadRoute, WhatIsNoRoute) {
    EXPECT_TRUE(names_fault(walk("where to?\n"), "oblong", file_, "line 1: 'where to?', expected x,y,z"));
    const Outcome alone = run_program({"oblong", "--route", file_});
    EXPECT_EQ(alone.exit_code, 2) << "nothing to record into: " << alone.error;
}

}  // namespace
}  // namespace oblong::test
