#include "tools/probe/probe.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

#include "engine/programs/arguments.h"

namespace oblong {
namespace {

std::string ask(std::string_view line) {
    return Probe().answer(line);
}

TEST(Probe, AnswersTheExamplesOfItsProtocol) {
    EXPECT_EQ(ask("project 320 200 4 3 90 1 1 4"), "200 66.66796875");  // 66 2/3 to the nearest 1/256
    EXPECT_EQ(ask("coverage 16 0 0 64 0 0 64"), "3 0 0 3 1 0 2 2 0 1");
    EXPECT_EQ(ask("recip 131072"), "0.5");
    EXPECT_EQ(ask("recip 0"), "inf");
}

TEST(Probe, GivesNumbersWithAllTheirDigits) {
    EXPECT_EQ(ask("sqrt 65536"), "1");
    EXPECT_EQ(ask("sqrt 0"), "0");
    EXPECT_EQ(ask("sqrt 1"), "0.00390625");
    EXPECT_EQ(ask("recip 1"), "65536");
    EXPECT_EQ(ask("sin 16384"), "1");
    EXPECT_EQ(ask("sin -16384"), "-1");
    EXPECT_EQ(ask("cos 32768"), "-1");
    EXPECT_EQ(ask("sin 16384000000000000000000000000"), ask("sin 0"));  // whole turns: 16384000... = 65536 * 250...
    EXPECT_EQ(ask("sin 1"), "0.0000958740711212158203125");             // 102944 / 2^30
}

TEST(Probe, ReadsDecimalsInEveryWayOfWritingThem) {
    const std::string expected = ask("project 320 200 4 3 90 1 0.5 4");
    EXPECT_EQ(ask("project 320 200 4 3 90.000 +1.0 .5 4."), expected);
    EXPECT_EQ(ask("project 320 200 4 3 9e1 1e0 5e-1 0.04E+2"), expected);
    EXPECT_EQ(ask("project 320 200 4 3 90 1 0.50000000000000000000000000000 4"), expected);
}

TEST(Probe, TellsWhatIsBehindTheEye) {
    for (const char* z : {"0", "-0", "-0.00390625", "-32767"})
        EXPECT_EQ(ask(std::string("project 320 200 4 3 90 1 1 ") + z), "behind");
    EXPECT_EQ(ask("view 320 200 4 3 90 1 2 3 0 0 0 1 2 3"), "behind");
    // A quarter turn exactly: what lies straight ahead of the unturned view now lies beside, at a depth of 0.
    EXPECT_EQ(ask("view 320 200 4 3 90 0 0 0 16384 0 0 0 0 100"), "behind");
    EXPECT_EQ(ask("view 320 200 4 3 90 0 0 0 -16384 0 0 -5 0 0"), "160 100 5");
}

TEST(Probe, RefusesWhatIsNotAQuery) {
    const char* lines[] = {"",
                           " ",
                           "unknown",
                           "project",
                           "project 320 200 4 3 90 1 1",
                           "project 320 200 4 3 90 1 1 4 5",
                           "project 320 200 4 3 90 1 1 4 ",
                           "project  320 200 4 3 90 1 1 4",
                           "project 320 200 4 3 90 1 1 0.001",
                           "project 320 200 4 3 0 1 1 4",
                           "project 320 200 4 3 180 1 1 4",
                           "project 320 200 4 3 -90 1 1 4",
                           "project 320 200 4 3 nan 1 1 4",
                           "project 320 200 4 3 inf 1 1 4",
                           "project 0 200 4 3 90 1 1 4",
                           "project 320 200 4 0 90 1 1 4",
                           "project 320 200 4 3 90 1 1 32768",
                           "project 320 200 4 3 90 1 1 0x4",
                           "project 320.5 200 4 3 90 1 1 4",
                           "project 320 200 4 3 90 1 1 1e999999999999",
                           "project 320 200 4 3 90 1 1 e",
                           "project 320 200 4 3 90 1 1 -",
                           "project 320 200 4 3 90 1 1 .",
                           "project 320 200 4 3 90 1 1 1e",
                           "coverage 15 0 0 64 0 0 64",
                           "coverage 16 0 0 64 0 0",
                           "coverage 16 0 0 64 0 0 6.4",
                           "coverage 16 0 0 99999999999999999999 0 0 64",
                           "mesh 16 3 0 0 1 0 0 1 1 0 1 3",
                           "mesh 16 3 0 0 1 0 0 1 1 0 1 -1",
                           "mesh 16 3 0 0 1 0 0 1 2 0 1 2",
                           "mesh 16 1000000000000 0 0",
                           "mesh 16 -1",
                           "mesh 16 0",
                           "clip 320 200 4 3 90 4 8192 2 0 0 5 1 0 5",
                           "clip 320 200 4 3 90 4 8192 99999999999 0 0 5 1 0 5",
                           "sqrt -1",
                           "sqrt 2147483648",
                           "recip -1",
                           "sin",
                           "sin 1.5",
                           "sin -",
                           "sin 1 2",
                           "modes please",
                           "leaf /nowhere/at/all.bsp 0 0 0",
                           "leaf /dev/stdin 0 0 0",
                           "leaf / 0 0 0",
                           "texspan 320 200 4 3 90 0 0 4 0 0 0 0 4 0 0 0 0 4 0 0 100 10 12",
                           "texspan 320 200 4 3 90 -9 -9 4 0 0 9 -9 4 9 0 0 9 4 0 9 200 10 12",
                           "texspan 320 200 4 3 90 -9 -9 4 0 0 9 -9 4 9 0 0 9 4 0 9 100 12 12",
                           "texspanq best 320 200 4 3 90 -9 -9 4 0 0 9 -9 4 9 0 0 9 4 0 9 100 158 162"};
    for (const char* line : lines) EXPECT_EQ(ask(line), "unsupported") << '"' << line << '"';
}

TEST(Probe, RefusesFieldsOfViewThatAreTooNarrowForTheMultipliersOfAFrame) {
    EXPECT_EQ(ask("texspan 8192 200 4 3 0.0001 -9 -9 4 0 0 9 -9 4 9 0 0 9 4 0 9 100 4000 4001"), "unsupported");
    EXPECT_EQ(ask("clip 8192 200 4 3 0.0001 4 8192 3 -9 -9 4 9 -9 4 0 9 4"), "unsupported");
    EXPECT_EQ(ask("clip 320 200 4 3 0.01 4 8192 3 -9 -9 4 9 -9 4 0 9 4"), "64000");
    EXPECT_NE(ask("project 8192 200 4 3 0.0001 1 1 4"), "unsupported");  // which a frame would clip
}

TEST(Probe, ClipsToTheSidesOfTheViewWhereTheNearPlaneIsNotBeforeTheEye) {
    // Seen whole, 10 x 10 units from 5: 320 x 266 2/3 pixels, of which 200 rows are on the screen.
    const std::string square = " 8192 4 -5 -5 5 5 -5 5 5 5 5 -5 5 5";
    for (const char* near : {"0", "-0.00390625", "-32767", "5"})
        EXPECT_EQ(ask(std::string("clip 320 200 4 3 90 ") + near + square), "64000") << near;
    EXPECT_EQ(ask("clip 320 200 4 3 90 5.00390625" + square), "0");
    EXPECT_EQ(ask("clip 320 200 4 3 90 8 4 3 -5 -5 2 5 -5 5 0 5 9"), "0");  // near beyond far
    EXPECT_EQ(ask("clip 320 200 4 3 90 -8 -4 3 -5 -5 -5 5 -5 -5 0 5 -5"), "0");
}

TEST(Probe, AnEyeInThePlaneOfAPolygonSeesNothingOfIt) {
    // Planes through the eye that no axis lies in; clipping them leaves slivers. Far, and around the eye.
    EXPECT_EQ(ask("clip 1280 1024 5 4 30 0.015625 4096 3 3 1 2 1 2 4 4 3 6"), "0");
    EXPECT_EQ(ask("clip 320 200 4 3 90 4 8192 4 -3001 -1999 -500 -999 -2001 1000 3001 1999 500 999 2001 -1000"), "0");
    EXPECT_EQ(ask("clip 320 200 4 3 90 0 8192 3 -1 -1 0 1 -1 0 0 1 0"), "0");
    EXPECT_EQ(ask("clip 320 200 4 3 90 4 8192 5 7 3 90 7 3 90 14 6 180 14 6 180 -1 2 50"), "0");
    // 1/256 unit off such a plane it is seen.
    EXPECT_NE(ask("clip 320 200 4 3 90 4 8192 3 -3001 -1999.00390625 -500 -999 -2001 1000 3001 1999 500"), "0");
}

TEST(Probe, AnswersEachLineByOneLineHoweverLongItIsAndTheLastWithoutItsEnd) {
    std::istringstream in("sqrt 65536\n" + std::string(1 << 20, '9') + "\n\nsqrt 0");
    std::ostringstream out;
    answer_lines({}, in, out);
    EXPECT_EQ(out.str(), "1\nunsupported\nunsupported\n0\n");
}

TEST(Probe, NamesItsTexturingModesMostAccurateFirst) {
    EXPECT_EQ(ask("modes"), "exact bounded-texels bounded every8 every16 every32 affine");
    const std::string span = "320 200 4 3 90 -100 -100 50 0 0 100 -100 500 64 0 0 100 50 32 64 110 158 162";
    EXPECT_EQ(ask("texspan " + span), ask("texspanq exact " + span));
    EXPECT_NE(ask("texspan " + span), ask("texspanq affine " + span));
}

/// An answer's first number, with a dial turned.
double first_number(const std::string& dial, const std::string& query) {
    Accuracy accuracy;
    parse_dial(dial, accuracy);
    return std::stod(Probe(accuracy).answer(query));
}

TEST(Probe, DialsAddTheErrorsThatTheyStandFor) {
    const double thirtieth = std::sin(2 * std::numbers::pi * 100 / 65536);
    EXPECT_NEAR(first_number("sine=exact", "sin 100"), thirtieth, 0x1p-30);
    EXPECT_NEAR(first_number("sine=quarter1024", "sin 100"), thirtieth, 0x1p-21);
    EXPECT_EQ(first_number("sine=nearest256", "sin 100"), 0) << "nearer to 0 than to the first of 256 steps";
    // A wall at a slant: u = 64 (z - 50) / 450, and at the centre of the view 1/z is the mean of both ends'.
    const std::string wall = "texspan 320 200 4 3 90 -50 -100 50 0 0 500 -100 500 64 0 -50 100 50 0 64 100 160 161";
    const double exact = first_number("reciprocal=exact", wall), coarse = first_number("reciprocal=table256", wall);
    EXPECT_GT(std::abs(coarse - exact), 1e-4);
    EXPECT_LT(std::abs(coarse / exact - 1), 0x1p-8);
    EXPECT_GT(std::abs(first_number("inverse-z-bits=16", wall) - exact), 1e-3);
}

TEST(Probe, AnAccumulatedEdgeMissesColumnsOfTallTriangles) {
    Accuracy accumulated;
    accumulated.edges = EdgeStepping::Accumulated;
    std::mt19937 random(5);
    int wrong = 0;
    for (int i = 0; i < 2000; ++i) {
        std::string query = "coverage 16";
        for (int corner = 0; corner < 3; ++corner)
            query += ' ' + std::to_string(random() % 5120) + ' ' + std::to_string(random() % 3200);
        wrong += Probe(accumulated).answer(query) != ask(query);
    }
    // period-costs: a pixel wrong in a tenth of the triangles. Here slopes are rounded to the nearest, not floored.
    EXPECT_GT(wrong, 20);
    EXPECT_LT(wrong, 300);
}

}  // namespace
}  // namespace oblong
