// Draws cameras of levels, ordinary and extreme, by an engine that records the range of its intermediate values, and
// prints what they took, what they may take and the bits between. Exits with 1 if less than a bit is left anywhere.
//   record_ranges PALETTE (LEVEL.bsp CAMERAS.csv)...
#include <algorithm>
#include <bit>
#include <cinttypes>
#include <cstdio>
#include <cstring>
#include <string_view>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/programs/arguments.h"
#include "engine/scene/placed_models.h"
#include "tools/render/camera_list.h"

#if !defined(OBLONG_RECORD_RANGES)
#error "only a recording engine has ranges to print: see tests/ranges/check_ranges"
#endif

namespace {

using namespace oblong;

constexpr std::int32_t kWorldEnd = 32767;
constexpr std::size_t kCameraStep = 20;  // of a level's cameras, one in so many

void draw(const Scene& scene, const std::vector<Camera>& cameras, const ScreenMode& mode, Preset preset) {
    FrameWorkspace work(scene.level, mode);
    Settings settings;
    settings.accuracy = accuracy_of(preset);
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(mode.width_px) *
                                     static_cast<std::size_t>(mode.height_px));
    for (const Camera& camera : cameras)
        draw_frame(scene, camera, mode, settings, work, {pixels.data(), mode.width_px, mode.height_px, mode.width_px});
}

std::vector<Camera> with_field_of_view(std::vector<Camera> cameras, std::int64_t degrees) {
    for (Camera& camera : cameras) camera.field_of_view = Degrees::from_int(degrees);
    return cameras;
}

/// From every corner of the largest world toward its middle, away from it, and along its edges.
std::vector<Camera> corner_cameras() {
    std::vector<Camera> cameras;
    for (unsigned corner = 0; corner < 8; ++corner) {
        const auto end = [&](unsigned axis) { return World::from_int(corner >> axis & 1 ? kWorldEnd : -kWorldEnd); };
        for (unsigned eighth = 0; eighth < 8; ++eighth)
            for (const std::int32_t pitch : {0, 6444, 65536 - 6444}) {
                Camera camera;
                camera.eye = {end(0), end(1), end(2)};
                camera.yaw = Angle{static_cast<std::uint16_t>(eighth * 8192)};
                camera.pitch = Angle{static_cast<std::uint16_t>(pitch)};
                cameras.push_back(camera);
            }
    }
    return cameras;
}

void draw_level(const std::string& level_path, const std::string& cameras_path, const Colormap& colormap) {
    const Level level = read_parsed(level_path, read_bsp);
    const std::vector<PlacedModel> models = models_at_rest(level);
    const Scene scene{level, colormap, models};
    const std::vector<Camera> all =
        read_parsed(cameras_path, [](const auto& bytes) { return parse_cameras(bytes, Degrees::from_int(90)); });
    std::vector<Camera> some, few;
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (i % kCameraStep == 0) some.push_back(all[i]);
        if (i % (kCameraStep * 15) == 0) few.push_back(all[i]);
    }
    for (const Preset preset : {Preset::Year1991, Preset::Bounded, Preset::Exact}) draw(scene, some, {}, preset);
    for (const std::int64_t degrees : {1, 10, 170, 179}) {
        draw(scene, with_field_of_view(some, degrees), {}, Preset::Bounded);
        draw(scene, with_field_of_view(corner_cameras(), degrees), {}, Preset::Bounded);
        draw(scene, with_field_of_view(few, degrees), {kLargestMode_px, kLargestMode_px, {4, 3}}, Preset::Bounded);
        draw(scene, with_field_of_view(few, degrees), {8, kLargestMode_px, {16, 9}}, Preset::Exact);
    }
    draw(scene, few, {kLargestMode_px, kLargestMode_px, {4, 3}}, Preset::Bounded);
}

/// How many bits the size of a value takes, its sign not counted.
constexpr int bits_of(std::int64_t value) {
    return static_cast<int>(std::bit_width(static_cast<std::uint64_t>(value < 0 ? ~value : value)));
}

static_assert(bits_of(0) == 0 && bits_of(1) == 1 && bits_of(255) == 8 && bits_of(256) == 9);
static_assert(bits_of(-1) == 0 && bits_of(-256) == 8 && bits_of(-257) == 9);

/// The file below engine/, or what a quantity gets that was never noted.
std::string place_of(const SeenRange& seen) {
    const std::string path = seen.file ? seen.file : "never noted";
    const std::size_t engine = path.rfind("engine/");
    return engine == std::string::npos ? path : path.substr(engine + 7);
}

/// Prints a row of the table; its head-room in bits, or -1 if the quantity was never noted.
int print_row(const SeenRange& seen) {
    const int bits = seen.file ? std::max(bits_of(seen.least), bits_of(seen.greatest)) : seen.bits + 1;
    const int whole_bits = seen.bits + 1 - seen.fraction_bits;
    std::printf("| %s | %d.%d | %s | %" PRId64 " | %" PRId64 " | %d | %d | %d |\n", seen.name, whole_bits,
                seen.fraction_bits, place_of(seen).c_str(), seen.least, seen.greatest, bits, seen.bits,
                seen.bits - bits);
    return seen.bits - bits;
}

/// Prints the table; the least head-room in it.
int print_table() {
    std::vector<const SeenRange*> ranges = recorded_ranges();
    std::sort(ranges.begin(), ranges.end(), [](const SeenRange* a, const SeenRange* b) {
        return std::pair(place_of(*a), std::string_view(a->name)) < std::pair(place_of(*b), std::string_view(b->name));
    });
    std::printf(
        "| quantity | format | in engine/ | smallest | largest | bits | of | head-room "
        "|\n|---|---|---|---|---|---|---|---|\n");
    int least = ranges.empty() ? -1 : 63;
    for (const SeenRange* seen : ranges) least = std::min(least, print_row(*seen));
    return least;
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 4 || argc % 2 != 0) {
        std::fprintf(stderr, "record_ranges PALETTE (LEVEL.bsp CAMERAS.csv)...\n");
        return 2;
    }
    int least = -1;
    const int failed = run_program("record_ranges", [&] {
        const Colormap colormap = make_colormap(read_parsed(argv[1], read_palette));
        for (int i = 2; i < argc; i += 2) draw_level(argv[i], argv[i + 1], colormap);
        least = print_table();
    });
    return failed != 0 || least < 1 ? 1 : 0;
}
