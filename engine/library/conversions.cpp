#include "engine/library/conversions.h"

#include <algorithm>

#include "engine/programs/arguments.h"
#include "engine/programs/frame_log.h"

namespace oblong {
namespace {

constexpr std::int64_t kMost = 8'000'000;  // times 256 fits 32 bits

std::int32_t bounded_256(std::int64_t any_256) {
    return static_cast<std::int32_t>(std::clamp(any_256, -kMost * 256, kMost * 256));
}

std::int32_t as_256(std::int64_t whole) {
    return bounded_256(whole * 256);
}

std::string size_of(std::int32_t width_px, std::int32_t height_px) {
    return std::to_string(width_px) + "x" + std::to_string(height_px);
}

}  // namespace

const char* version() {
    return OBLONG_VERSION;
}

int report(const std::exception& error) {
    standard_error_lines()(message_of(error));
    return 1;
}

std::string beside_program(const std::string& file) {
    return program_folder("./") + "/" + file;
}

File::File(const char* its_name) : name(its_name) {}
File::File(std::string its_name) : name(std::move(its_name)) {}
File::File(std::string its_name, std::span<const std::uint8_t> its_bytes)
    : name(std::move(its_name)), bytes(its_bytes) {}

std::runtime_error argument_error(const std::string& name, const std::string& what_is_wrong) {
    return std::runtime_error(name + ": " + what_is_wrong);
}

std::int32_t sine_65536(std::int64_t degrees_256) {
    constexpr std::int64_t kHalf = std::int64_t{1} << 13;
    return static_cast<std::int32_t>((sine(angle_from_256(degrees_256)).raw + kHalf) >> 14);
}

void add_typed(std::string& text, std::string_view typed) {
    const auto is_inside_letter = [](char byte) { return (byte & 0xC0) == 0x80; };  // of UTF-8
    for (const char byte : typed) {
        if (byte != '\b') {
            text += byte;
            continue;
        }
        while (!text.empty() && is_inside_letter(text.back())) text.pop_back();
        if (!text.empty()) text.pop_back();
    }
}

std::int32_t direction_256(std::int64_t x, std::int64_t y) {
    return (arctangent2(y, x).bam * 360 + 128) / 256;
}

// SplitMix64 (Steele, Lea, Flood 2014); the high half of a product replaces a remainder.
std::int32_t random_below(std::int32_t limit, std::uint64_t& state) {
    state += 0x9E37'79B9'7F4A'7C15u;
    std::uint64_t mixed = state;
    mixed = (mixed ^ mixed >> 30) * 0xBF58'476D'1CE4'E5B9u;
    mixed = (mixed ^ mixed >> 27) * 0x94D0'49BB'1331'11EBu;
    mixed ^= mixed >> 31;
    return static_cast<std::int32_t>((mixed >> 32) * static_cast<std::uint32_t>(std::max(limit, 1)) >> 32);
}

Pose pose_at(std::int32_t x, std::int32_t y, std::int32_t z, std::int32_t yaw, std::int32_t pitch, std::int32_t roll) {
    return {as_256(x), as_256(y), as_256(z), as_256(yaw), as_256(pitch), as_256(roll)};
}

Pose moved(const Pose& pose, std::int32_t ahead_256, std::int32_t right_256, std::int32_t up_256) {
    const std::int64_t sine = sine_65536(pose.yaw_256), cosine = sine_65536(std::int64_t{pose.yaw_256} + 90 * 256);
    Pose after = pose;
    after.x_256 = bounded_256(pose.x_256 + ((ahead_256 * cosine + right_256 * sine) >> 16));
    after.y_256 = bounded_256(pose.y_256 + ((ahead_256 * sine - right_256 * cosine) >> 16));
    after.z_256 = bounded_256(std::int64_t{pose.z_256} + up_256);
    return after;
}

const ScreenMode& checked(const ScreenMode& mode) {
    const auto is_side = [](std::int32_t side_px) { return side_px >= 1 && side_px <= kLargestMode_px; };
    if (!is_side(mode.width_px) || !is_side(mode.height_px))
        throw argument_error("mode", size_of(mode.width_px, mode.height_px) + " pixels, expected 1 to " +
                                         std::to_string(kLargestMode_px) + " a side");
    const auto [width, height] = mode.display;
    constexpr std::int64_t kMostNumber = 10'000, kMostShape = 100;  // as of --display
    if (width < 1 || height < 1 || std::max(width, height) > kMostNumber ||
        std::max(width, height) > kMostShape * std::min(width, height))
        throw argument_error("mode", "a display of " + std::to_string(width) + ":" + std::to_string(height) +
                                         ", expected numbers from 1 to 10000, and 1:100 to 100:1");
    return mode;
}

const Picture& checked(const Picture& picture) {
    if (picture.width_px >= 0 && picture.height_px >= 0 &&
        picture.pixels.size() == pixel_count(picture.width_px, picture.height_px))
        return picture;
    throw argument_error("picture", std::to_string(picture.pixels.size()) + " pixels, expected " +
                                        size_of(picture.width_px, picture.height_px));
}

void check_size(const Framebuffer& canvas, const ScreenMode& mode) {
    if (canvas.width_px != mode.width_px || canvas.height_px != mode.height_px)
        throw argument_error("canvas", "has " + size_of(canvas.width_px, canvas.height_px) + " pixels, expected " +
                                           size_of(mode.width_px, mode.height_px) + ", those of the mode");
    if (canvas.pitch < canvas.width_px)
        throw argument_error("canvas", "has a pitch of " + std::to_string(canvas.pitch) + ", expected " +
                                           std::to_string(canvas.width_px) + " or more");
}

Pose pose_of(const Vec3<World>& place) {
    return {to_256(place.x), to_256(place.y), to_256(place.z)};
}

Camera camera_of(const Pose& eye, std::int32_t field_of_view) {
    Camera camera;
    camera.eye = place_of(eye);
    camera.yaw = angle_from_256(eye.yaw_256);
    camera.pitch = angle_from_256(eye.pitch_256);
    camera.roll = angle_from_256(eye.roll_256);
    camera.field_of_view = Degrees::from_int(std::clamp(field_of_view, 1, 179));
    return camera;
}

}  // namespace oblong
