#include "engine/library/conversions.h"

#include <algorithm>

#include "engine/base/input_error.h"
#include "engine/files/arguments.h"
#include "engine/files/frame_log.h"

namespace oblong {
namespace {

std::int32_t as_256(std::int64_t whole) {
    constexpr std::int64_t kMost = 8'000'000;  // times 256 fits 32 bits
    return static_cast<std::int32_t>(std::clamp(whole, -kMost, kMost) * 256);
}

}  // namespace

const char* version() {
    return OBLONG_VERSION;
}

int report(const std::exception& error) {
    standard_error_lines()(message_of(error));
    return 1;
}

std::int32_t sine_65536(std::int64_t degrees_256) {
    constexpr std::int64_t kHalf = std::int64_t{1} << 13;
    return static_cast<std::int32_t>((sine(angle_from_256(degrees_256)).raw + kHalf) >> 14);
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
    after.x_256 += static_cast<std::int32_t>((ahead_256 * cosine + right_256 * sine) >> 16);
    after.y_256 += static_cast<std::int32_t>((ahead_256 * sine - right_256 * cosine) >> 16);
    after.z_256 += up_256;
    return after;
}

void check_size(const Framebuffer& canvas, const ScreenMode& mode) {
    if (canvas.width_px == mode.width_px && canvas.height_px == mode.height_px) return;
    const auto size = [](std::int32_t width_px, std::int32_t height_px) {
        return std::to_string(width_px) + "x" + std::to_string(height_px);
    };
    throw InputError("canvas", "has " + size(canvas.width_px, canvas.height_px) + " pixels, expected " +
                                   size(mode.width_px, mode.height_px) + ", those of the mode");
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
