#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>

#include "engine/io/files.h"
#include "engine/pictures/picture.h"
#include "tests/support/pictures.h"
#include "tests/support/programs.h"

// The programs of engine/examples, run without a window.
namespace oblong::test {
namespace {

namespace fs = std::filesystem;

constexpr double kDegree = 3.14159265358979323846 / 180;

struct Shot {
    const char *example, *name;  // the picture's on the page
    int pictures;                // until the one that is kept; by a clock of 70 a second

    int time_ms() const { return (pictures - 1) * 1000 / 70; }
};

constexpr Shot kShots[] = {{"breakout", "breakout", 180},
                           {"circle", "circle1", 4},
                           {"circle", "circle2", 144},
                           {"circle", "circle3", 284},
                           {"circle", "circle4", 424},
                           {"collect", "collect", 20},
                           {"cube", "cube", 60},
                           {"demo", "demo", 401},
                           {"door", "door", 25},
                           {"fire", "fire", 70},
                           {"floor", "floor", 1},
                           {"input", "input", 1},
                           {"lines", "lines", 60},
                           {"models", "models", 60},
                           {"orbit", "orbit", 1},
                           {"plasma", "plasma", 40},
                           {"rotozoomer", "rotozoomer", 30},
                           {"sheet", "sheet", 130},
                           {"split", "split", 20},
                           {"sprites", "sprites", 130},
                           {"stars", "stars", 70},
                           {"tick", "tick", 180},
                           {"tiles", "tiles", 130},
                           {"walk", "walk", 20}};

struct Shown {
    PngImage picture;  // the last
    std::string file, printed;

    int at(int x, int y) const { return picture.indices[static_cast<std::size_t>(y * picture.width_px + x)]; }
};

Shown show(const Shot& shot, const std::string& accuracy = "") {
    static const TemporaryFolder folder;
    const std::string file = folder.path(shot.name + std::string(".png")), printed = folder.path("printed");
    const std::string line = "OBLONG_HEADLESS=" + std::to_string(shot.pictures) + ":" + file + " " +
                             program(std::string("example_") + shot.example) + " '" + build_folder() + "/assets' " +
                             accuracy;
    const Outcome outcome = run_line(line, printed);
    EXPECT_EQ(outcome.exit_code, 0) << line << "\n" << outcome.error;
    return {decode_png(read_file(file)), file, read_text(printed)};
}

void PrintTo(const Shot& shot, std::ostream* out) {
    *out << shot.name;
}

Shot shot_of(const std::string& name) {
    return *std::find_if(std::begin(kShots), std::end(kShots), [&](const Shot& shot) { return shot.name == name; });
}

class Example : public testing::TestWithParam<Shot> {};

/// OBLONG_WRITE_PICTURES=1 build/bin/test_examples puts the pictures beside the examples.
TEST_P(Example, LooksAsOnItsPage) {
    const Shown found = show(GetParam());
    const std::string page = source_folder() + "/engine/examples/" + GetParam().name + ".png";
    if (std::getenv("OBLONG_WRITE_PICTURES") != nullptr)
        fs::copy_file(found.file, page, fs::copy_options::overwrite_existing);
    const PngImage expected = decode_png(read_file(page));
    EXPECT_EQ(found.picture.colours, expected.colours);
    EXPECT_TRUE(same_picture(found.picture.indices, expected.indices, static_cast<std::size_t>(expected.width_px)));
}

INSTANTIATE_TEST_SUITE_P(Pictures, Example, testing::ValuesIn(kShots),
                         [](const auto& shot) { return std::string(shot.param.name); });

TEST(Examples, EachIsShortHasAPictureAndSaysWhyItCannotStart) {
    std::uintmax_t bytes = 0;
    int examples = 0;
    for (const auto& entry : fs::directory_iterator(source_folder() + "/engine/examples")) {
        if (entry.path().extension() == ".png") bytes += entry.file_size();
        if (entry.path().extension() != ".cpp") continue;
        const std::string source = read_text(entry.path().string()), name = entry.path().stem().string();
        EXPECT_LT(std::count(source.begin(), source.end(), '\n'), 80) << name;
        const Outcome refused = run_line("OBLONG_HEADLESS=none " + program("example_" + name));
        EXPECT_EQ(refused.exit_code, 1) << name;
        EXPECT_EQ(refused.error, "OBLONG_HEADLESS: 'none', expected FRAMES or FRAMES:FILE.png, one or more\n") << name;
        EXPECT_TRUE(std::any_of(std::begin(kShots), std::end(kShots), [&](const Shot& shot) {
            return shot.example == name;
        })) << name;
        ++examples;
    }
    EXPECT_EQ(examples, 21);
    EXPECT_LT(bytes, 220'000u);
}

/// Around the pixels of a colour, those of the first rows left out.
struct Box {
    int left = 1 << 20, right = -1, top = 1 << 20, bottom = -1;

    Box(const Shown& run, int colour, int first_row) {
        for (int y = first_row; y < run.picture.height_px; ++y)
            for (int x = 0; x < run.picture.width_px; ++x)
                if (run.at(x, y) == colour) take(x, y);
    }
    void take(int x, int y) {
        left = std::min(left, x);
        right = std::max(right, x);
        top = std::min(top, y);
        bottom = std::max(bottom, y);
    }
    double width() const { return right - left + 1; }
    double height() const { return bottom - top + 1; }
};

TEST(Examples, CircleIsAsWideAsHighOnTheDisplayAndTheEggInPixels) {
    constexpr int kWhite = 2, kRed = 3;
    for (const char* name : {"circle1", "circle2", "circle3", "circle4"}) {
        const Shown shown = show(shot_of(name));
        // Of a display of 4 to 3.
        const double column = 4.0 / shown.picture.width_px, row = 3.0 / shown.picture.height_px;
        const Box circle(shown, kWhite, 20), egg(shown, kRed, 0);
        EXPECT_NEAR(circle.width() * column, circle.height() * row, std::max(column, row)) << name;
        EXPECT_NEAR(egg.width(), egg.height(), 1) << name;
        EXPECT_NEAR(egg.width(), circle.width(), 1) << name;
    }
}

TEST(Examples, CornersOfTheCubeAreWhereDoublesPutThem) {
    const Shot shot = shot_of("cube");
    const Shown shown = show(shot);
    const double spin = shot.time_ms() * 5 / 256.0 * kDegree, tilt = 25 * kDegree, yaw = 10 * kDegree;
    const Box edges(shown, 1, 0);
    Box corners(shown, -1, 0);
    for (const double x : {-1, 1})
        for (const double y : {-1, 1})
            for (const double z : {-1, 1}) {
                const double spun_x = x * std::cos(spin) + z * std::sin(spin),
                             spun_z = z * std::cos(spin) - x * std::sin(spin);
                const double world_y = y * std::cos(tilt) + spun_z * std::sin(tilt),
                             world_z = 5 + spun_z * std::cos(tilt) - y * std::sin(tilt), right = spun_x + 1;
                const double view_x = right * std::cos(yaw) - world_z * std::sin(yaw),
                             view_z = world_z * std::cos(yaw) + right * std::sin(yaw);
                const int column = static_cast<int>(std::floor(160 + 320 * view_x / view_z)),
                          row = static_cast<int>(std::floor(100 - 320 * 5 / 6.0 * world_y / view_z));
                corners.take(column, row);
                bool is_drawn = false;
                for (int i = 0; i < 9; ++i) is_drawn |= shown.at(column + i % 3 - 1, row + i / 3 - 1) == 1;
                EXPECT_TRUE(is_drawn) << x << ", " << y << ", " << z << ": " << column << ", " << row;
            }
    EXPECT_NEAR(edges.left, corners.left, 1);
    EXPECT_NEAR(edges.right, corners.right, 1);
    EXPECT_NEAR(edges.top, corners.top, 1);
    EXPECT_NEAR(edges.bottom, corners.bottom, 1);
}

/// How many of a thousand pixels from a row down have another colour than `expected` gives.
template <class Expected>
int unlike_1000(const Shown& shown, int first_row, const Expected& expected) {
    int unlike = 0, count = 0;
    for (int y = first_row; y < shown.picture.height_px; ++y)
        for (int x = 0; x < shown.picture.width_px; ++x, ++count)
            unlike += shown.at(x, y) != expected(x + 0.5, y + 0.5);
    return unlike * 1000 / count;
}

// The ray through a pixel's middle meets the floor 48 texels below the eye.
TEST(Examples, FloorShowsTheTexelThatEachRayMeets) {
    const Shown shown = show(shot_of("floor"));
    const double yaw = 20 * kDegree;
    EXPECT_LE(
        unlike_1000(shown, 100,
                    [&](double x, double y) {
                        const double down = (y - 100) * 6 / 5 / 160, ahead = 48 / down, right = ahead * (x - 160) / 160;
                        const auto u = static_cast<int>(std::floor(ahead * std::cos(yaw) + right * std::sin(yaw))),
                                   v = static_cast<int>(std::floor(ahead * std::sin(yaw) - right * std::cos(yaw)));
                        const int texel = (u & 63) < 4 || (v & 63) < 4 ? 2 : ((u >> 6) ^ (v >> 6)) & 1;
                        return texel * 32 + static_cast<int>(32 * 2 * (y - 100) / 200);
                    }),
        2);
}

// Turned and scaled (in 256ths of a texel) on the display, where a row is 6/5 as far as a column.
TEST(Examples, RotozoomerShowsSquares) {
    const Shot shot = shot_of("rotozoomer");
    const double turn = (30 + shot.time_ms() * 10 / 256.0) * kDegree,
                 scale = (140 + std::trunc(65536 / 600.0 * std::sin(shot.time_ms() * 16 / 256.0 * kDegree))) / 256;
    EXPECT_LE(unlike_1000(show(shot), 0,
                          [&](double x, double y) {
                              const double right = (x - 160.5) * scale, down = (y - 100.5) * 6 / 5 * scale;
                              const double u = right * std::cos(turn) - down * std::sin(turn),
                                           v = right * std::sin(turn) + down * std::cos(turn);
                              return (static_cast<int>(std::floor(u)) & 63) ^ (static_cast<int>(std::floor(v)) & 63);
                          }),
              20);
}

TEST(Examples, PlasmaMovesNoPixelButTheColours) {
    const Shot later = shot_of("plasma");
    const Shown first = show({"plasma", "plasma", 1}), last = show(later);
    EXPECT_EQ(first.picture.indices, last.picture.indices);
    const std::size_t places = static_cast<std::size_t>(later.time_ms() / 20);
    for (std::size_t i = 0; i < 256; ++i)
        EXPECT_EQ(last.picture.colours[(i + places) % 256], first.picture.colours[i]) << i;
}

// After 300 pictures flames that did not cool would have reached the top.
TEST(Examples, FireIsHotterBelowAndColdAtTheTop) {
    const Shown shown = show({"fire", "fire", 300});
    double below = 255;
    for (int band = 9; band >= 0; --band) {
        double sum = 0;
        for (int i = 0; i < 20 * 320; ++i) sum += shown.at(i % 320, band * 20 + i / 320);
        const double mean = sum / (20 * 320);
        EXPECT_LT(mean, below) << "rows from " << band * 20;
        below = mean;
    }
    EXPECT_LT(below, 1);
}

// As zlib's manual defines it: a remainder in the field of two elements.
std::uint32_t crc32_of(const std::vector<std::uint8_t>& bytes) {
    std::uint32_t rest = 0xFFFF'FFFF;
    for (const std::uint8_t byte : bytes) {
        rest ^= byte;
        for (int bit = 0; bit < 8; ++bit) rest = rest >> 1 ^ (rest & 1 ? 0xEDB8'8320 : 0);
    }
    return ~rest;
}

TEST(Examples, DemoPrintsTheSameSumsAgainAndOthersWithAnotherAccuracy) {
    const Shown first = show(shot_of("demo")), again = show(shot_of("demo")), other = show(shot_of("demo"), "1991");
    EXPECT_EQ(first.printed, again.printed);
    EXPECT_NE(first.printed, other.printed);
    std::array<char, 16> last;
    std::snprintf(last.data(), last.size(), " 400 %08x\n", crc32_of(first.picture.indices));
    EXPECT_TRUE(first.printed.ends_with(last.data())) << first.printed << "expected " << last.data();
}

}  // namespace
}  // namespace oblong::test
