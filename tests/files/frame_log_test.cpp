#include "engine/programs/frame_log.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engine/fixed/trig.h"
#include "engine/level/bsp_read.h"
#include "engine/programs/arguments.h"
#include "engine/programs/crosshair.h"
#include "engine/view/views.h"
#include "tests/support/bsp_writer.h"
#include "tests/support/palettes.h"
#include "tests/support/refusal.h"

namespace oblong {
namespace {

/// A frame of the tiny level, whose floor is 32 x 16 units at z = 8.
class FrameLogTest : public testing::Test {
  protected:
    FrameLogTest() {
        camera_.eye = {World::from_int(4), World::from_int(5), World::from_int(20)};
        camera_.yaw = degrees_to_angle(Degrees::from_int(30));
        camera_.pitch = degrees_to_angle(Degrees::from_int(40));
        draw();
    }

    void draw() { draw_frame(scene_, camera_, mode_, settings_, work_, {pixels_.data(), 64, 40, 64}); }

    LoggedFrame frame() {
        view_ = first_person_view(camera_);
        return {scene_, view_, mode_, settings_, work_};
    }

    /// A point of the world in viewspace, in double.
    std::array<double, 3> to_view_in_double(double x, double y, double z) const {
        const double yaw = camera_.yaw.bam * std::numbers::pi / 32768,
                     pitch = camera_.pitch.bam * std::numbers::pi / 32768;
        const double dx = x - 4, dy = y - 5, dz = z - 20;
        const double ahead = dx * std::cos(yaw) + dy * std::sin(yaw);
        return {dx * std::sin(yaw) - dy * std::cos(yaw), ahead * std::sin(pitch) + dz * std::cos(pitch),
                ahead * std::cos(pitch) - dz * std::sin(pitch)};
    }

    const Level level_ = read_bsp(test::join_lumps(29, test::make_tiny_lumps()));
    const Colormap colormap_ = make_colormap(test::grey_palette());
    const ScreenMode mode_{64, 40, {4, 3}};
    const Settings settings_;
    const Scene scene_{level_, colormap_, {}};
    Camera camera_;
    ViewSpec view_;
    FrameWorkspace work_{level_, mode_};
    std::vector<std::uint8_t> pixels_ = std::vector<std::uint8_t>(64 * 40);
};

/// The numbers of a line that follow its text up to and with `after`.
std::vector<double> numbers_after(const std::string& line, const std::string& after) {
    std::vector<double> numbers;
    const std::size_t start = line.find(after);
    if (start == std::string::npos) return numbers;
    const char* text = line.c_str() + start + after.size();
    while (*text != '\0') {
        char* end = nullptr;
        const double number = std::strtod(text, &end);
        if (end != text) numbers.push_back(number);
        text = end == text ? text + 1 : end;
    }
    return numbers;
}

const std::string& line_with(const LogLines& lines, const std::string& text) {
    static const std::string none;
    const auto found = std::find_if(lines.begin(), lines.end(),
                                    [&](const std::string& line) { return line.find(text) != std::string::npos; });
    EXPECT_NE(found, lines.end()) << text;
    return found == lines.end() ? none : *found;
}

TEST_F(FrameLogTest, MatricesAreThoseOfTheCameraInDouble) {
    const LogLines lines = matrix_lines(frame());
    const auto eye = to_view_in_double(0, 0, 0), x = to_view_in_double(1, 0, 0), y = to_view_in_double(0, 1, 0),
               z = to_view_in_double(0, 0, 1);
    const std::array<std::string, 3> names{"row right: ", "row up: ", "row forward: "};
    for (std::size_t i = 0; i < 3; ++i) {
        const auto row = numbers_after(line_with(lines, names[i]), names[i]);
        ASSERT_EQ(row.size(), 4u);
        EXPECT_NEAR(row[0], x[i] - eye[i], 1e-4);
        EXPECT_NEAR(row[1], y[i] - eye[i], 1e-4);
        EXPECT_NEAR(row[2], z[i] - eye[i], 1e-4);
        EXPECT_NEAR(row[3], eye[i], 1e-3) << "minus the eye along the axis";
    }
    const auto projection = numbers_after(line_with(lines, "projection"), "multipliers ");
    ASSERT_GE(projection.size(), 2u);
    EXPECT_NEAR(projection[0], 32, 1e-4) << "half the width, over tan(45 degrees)";
    EXPECT_NEAR(projection[1], 32 * (4 / 3.) * 40 / 64, 1e-4);
}

/// The sides that a point in viewspace is outside of, at 90 degrees across on 4:3.
std::string sides_in_double(double x, double y, double z) {
    std::string names;
    const auto add = [&names](bool is_outside, const char* name) {
        if (is_outside) names += (names.empty() ? "" : ", ") + std::string(name);
    };
    add(x < -z, "left");
    add(x > z, "right");
    add(y < -z * 3 / 4, "bottom");
    add(y > z * 3 / 4, "top");
    add(z < 0, "behind");
    return names.empty() ? "none" : names;
}

TEST_F(FrameLogTest, ClipSaysOfEachCornerWhereItIsAndWhatItIsOutsideOf) {
    const LogLines lines = clip_lines(frame());
    EXPECT_EQ(line_with(lines, "faces own pixels").substr(0, 37), "1 faces own pixels: 0 inside the view");
    const std::array<std::array<double, 2>, 4> corners{{{0, 0}, {0, 16}, {32, 16}, {32, 0}}};
    std::size_t index = 0;
    for (const std::string& line : lines) {
        if (!line.starts_with("corner ")) continue;
        ASSERT_LT(index, corners.size());
        const auto expected = to_view_in_double(corners[index][0], corners[index][1], 8);
        const auto found = numbers_after(line, "corner ");
        ASSERT_EQ(found.size(), 3u);
        for (std::size_t i = 0; i < 3; ++i) EXPECT_NEAR(found[i], expected[i], 2e-3);
        EXPECT_EQ(line.substr(line.find("outside of ") + 11), sides_in_double(expected[0], expected[1], expected[2]));
        ++index;
    }
    EXPECT_EQ(index, corners.size());
    int drawn = 0;
    for (const std::string& line : lines) {
        if (!line.starts_with("drawn corner ")) continue;
        ++drawn;
        const auto found = numbers_after(line, "drawn corner ");
        ASSERT_GE(found.size(), 5u);
        EXPECT_NEAR(found[3], 32 + 32 * found[0] / found[2], 0.01);
        EXPECT_NEAR(found[4], 20 - 32 * (4 / 3.) * 40 / 64 * found[1] / found[2], 0.01);
        const bool is_on_border = found[3] == 0 || found[3] == 64 || found[4] == 0 || found[4] == 40;
        EXPECT_EQ(line.find("on the border") != std::string::npos, is_on_border) << line;
    }
    EXPECT_GE(drawn, 4);
}

TEST_F(FrameLogTest, SpansAreThePixelsOfThePicture) {
    const LogLines lines = span_lines(frame());
    const auto walls = numbers_after(line_with(lines, "walls"), "walls: ");
    const auto torn = numbers_after(line_with(lines, "torn"), "torn: ");
    const auto free = numbers_after(line_with(lines, "void"), "void: ");
    ASSERT_EQ(walls.size(), 3u);
    EXPECT_EQ(walls[0], 1);
    EXPECT_EQ(walls[2] + torn.at(0) + free.at(0), 64 * 40);
    // The middle row: its columns are those whose rays meet the floor, in double.
    int first = 64, last = -1;
    for (int column = 0; column < 64; ++column) {
        const double right = (column + 0.5 - 32) / 32, up = -(20 + 0.5 - 20) / (32 * (4 / 3.) * 40 / 64);
        const auto zero = to_view_in_double(4, 5, 20);
        ASSERT_NEAR(zero[2], 0, 1e-12);
        const double yaw = camera_.yaw.bam * std::numbers::pi / 32768,
                     pitch = camera_.pitch.bam * std::numbers::pi / 32768;
        const double ahead = std::cos(pitch) + up * std::sin(pitch), down = std::sin(pitch) - up * std::cos(pitch);
        const double t = 12 / down;
        const double x = 4 + t * (ahead * std::cos(yaw) + right * std::sin(yaw));
        const double y = 5 + t * (ahead * std::sin(yaw) - right * std::cos(yaw));
        if (x < 0 || x > 32 || y < 0 || y > 16) continue;
        first = std::min(first, column), last = std::max(last, column);
    }
    const auto row = numbers_after(line_with(lines, "row 20"), "columns ");
    ASSERT_GE(row.size(), 2u);
    EXPECT_EQ(row[0], first);
    EXPECT_EQ(row[1], last);
    EXPECT_NE(line_with(lines, "row 20").find("floor"), std::string::npos);
}

TEST_F(FrameLogTest, MemoryAndLevelCountWhatIsThere) {
    const LogLines memory = memory_lines(frame());
    EXPECT_EQ(numbers_after(line_with(memory, "framebuffer"), "framebuffer ").at(0), 64 * 40);
    EXPECT_EQ(numbers_after(line_with(memory, "textures"), "textures ").at(0), 256 + 64 + 16 + 4);
    EXPECT_EQ(numbers_after(line_with(memory, "light"), "light ").at(0), 8);
    // A row's hull and count, three numbers, and 32 free spans of two 16-bit ends, with room for a few more.
    const double span_buffer = numbers_after(line_with(memory, "span buffer"), "span buffer ").at(0);
    EXPECT_GE(span_buffer, 40 * (12 + 32 * 4));
    EXPECT_LE(span_buffer, 40 * (12 + 36 * 4));
    double sum = 0;
    for (const std::string& line : memory)
        if (line != memory.back()) sum += numbers_after(line, ": ").at(0);
    EXPECT_EQ(numbers_after(memory.back(), "all rooms: ").at(0), sum);
    const LogLines level = level_lines(frame());
    for (const char* line : {"1 planes", "4 vertices", "1 faces", "1 nodes", "2 leaves", "1 textures", "1 entities",
                             "8 bytes of light", "1 bytes of visible sets"})
        EXPECT_NE(std::find(level.begin(), level.end(), line), level.end()) << line;
}

TEST_F(FrameLogTest, CacheSaysWhatWasBuiltSinceTheLastLine) {
    CacheTotals totals;
    const LogLines first = cache_lines(frame(), totals);
    EXPECT_EQ(first.at(0), "1 lit faces in this frame");
    EXPECT_TRUE(first.at(1).starts_with("1 surfaces built")) << first.at(1);
    const double texels = numbers_after(first.at(1), ", of ").at(0);
    EXPECT_GE(numbers_after(first.at(2), "").at(0), texels) << "rows are padded";
    draw();
    EXPECT_TRUE(cache_lines(frame(), totals).at(1).starts_with("0 surfaces built since the last line, of 0 texels"));
    work_.cache.surfaces.clear();
    draw();
    EXPECT_EQ(cache_lines(frame(), totals).at(1), "1 surfaces built since the last line, of " +
                                                      std::to_string(static_cast<int>(texels)) + " texels; 0 evicted");
}

TEST_F(FrameLogTest, WritesTheChosenChannelsAloneAndNothingWhenOff) {
    std::vector<std::string> written;
    const auto keep = [&written](const std::string& line) { written.push_back(line); };
    FrameLog(LogChannels{}, keep).note(frame());
    EXPECT_TRUE(written.empty());
    for (std::size_t i = 0; i < kLogChannelCount; ++i) {
        written.clear();
        FrameLog(LogChannels::only(static_cast<LogChannel>(i)), keep).note(frame());
        EXPECT_FALSE(written.empty());
        for (const std::string& line : written) EXPECT_TRUE(line.starts_with(std::string(kLogChannelNames[i]) + ": "));
    }
}

TEST_F(FrameLogTest, IsWrittenAtMostOnceASecondAndTheLevelOnce) {
    std::vector<std::string> written;
    FrameLog log(parse_log_channels("level,spans"), [&written](const std::string& line) { written.push_back(line); });
    log.note_each_second(frame(), 5'000'000);
    const std::size_t both = written.size();
    log.note_each_second(frame(), 5'999'999);
    EXPECT_EQ(written.size(), both);
    log.note_each_second(frame(), 6'000'000);
    EXPECT_EQ(written.size(), both + span_lines(frame()).size());
}

TEST_F(FrameLogTest, PickedFaceIsDescribed) {
    Camera down = camera_;
    down.pitch = kQuarterTurn;
    const auto picked = pick_ahead(level_, {}, down);
    EXPECT_EQ(describe_picked(level_, {}, picked),
              "floor, 12.00 units ahead at 4.0 5.0 8.0\nface 0, plane 0 (0.00 0.00 1.00), world");
    down.pitch = -kQuarterTurn;
    EXPECT_EQ(describe_picked(level_, {}, pick_ahead(level_, {}, down)), "Nothing ahead");
}

TEST(LogChannels, AreParsedByNameAndUnknownOnesNameTheKnown) {
    EXPECT_EQ(names_of(parse_log_channels("clip,matrices")), "matrices,clip");
    EXPECT_EQ(parse_log_channels(names_of(LogChannels::all())), LogChannels::all());
    for (const char* text : {"", "clips", "clip,", "clip,,spans", "all"})
        EXPECT_NE(
            test::refusal<UsageError>([&] { parse_log_channels(text); }).find("level,memory,matrices,clip,spans,cache"),
            std::string::npos)
            << text;
}

TEST(LogChannels, KeyStepsThroughEachAllAndOff) {
    LogChannels channels;
    std::string seen;
    do {
        channels = next_channels(channels);
        seen += names_of(channels) + ";";
    } while (!channels.is_empty());
    EXPECT_EQ(seen, "level;memory;matrices;clip;spans;cache;level,memory,matrices,clip,spans,cache;off;");
    EXPECT_EQ(next_channels(parse_log_channels("clip,spans")), LogChannels::only(LogChannel::Level));
}

}  // namespace
}  // namespace oblong
