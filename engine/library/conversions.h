#pragma once

#include <memory>
#include <stdexcept>
#include <string>

#include "engine/fixed/trig.h"
#include "engine/io/files.h"
#include "engine/library/oblong.h"
#include "engine/math/vec.h"
#include "engine/mesh/placed_mesh.h"
#include "engine/view/projection.h"

// From the types of oblong.h to the engine's.

namespace oblong {

/// Converts 256ths of a unit, clamped to the range of the world.
constexpr World world_from_256(std::int64_t units_256) {
    constexpr std::int64_t kFarthest_256 = std::int64_t{500'000} * 256;
    const std::int64_t bounded = units_256 < -kFarthest_256  ? -kFarthest_256
                                 : units_256 > kFarthest_256 ? kFarthest_256
                                                             : units_256;
    return World::from_raw(static_cast<std::int32_t>(bounded * 16));
}
constexpr std::int32_t to_256(World world) {
    return floor_of<8>(world);
}
inline Vec3<World> place_of(const Pose& pose) {
    return {world_from_256(pose.x_256), world_from_256(pose.y_256), world_from_256(pose.z_256)};
}

/// Converts 256ths of a degree, of any number of turns.
constexpr Angle angle_from_256(std::int64_t degrees_256) {
    constexpr std::int64_t kTurn_256 = 360 * 256;
    const std::int64_t turned = (degrees_256 % kTurn_256 + kTurn_256) % kTurn_256;
    return Angle::from_bam((turned * 65536 + kTurn_256 / 2) / kTurn_256);
}

/// Of an argument, or the object that it is for, by its name: what() has it, as oblong.h says.
std::runtime_error argument_error(const std::string& name, const std::string& what_is_wrong);

/// Throws such an error unless the engine can draw in a mode.
const ScreenMode& checked(const ScreenMode& mode);
/// Throws such an error unless a picture has as many pixels as its size says.
const Picture& checked(const Picture& picture);
/// Throws such an error if a canvas does not have the mode's size, or rows that overlap.
void check_size(const Framebuffer& canvas, const ScreenMode& mode);

/// parse(the bytes of a file, in memory or read now); errors name it.
template <class Parse>
auto read_parsed(const File& file, Parse parse) {
    if (file.bytes.empty()) return read_parsed(file.name, parse);
    return naming_file(file.name, [&] { return parse(file.bytes); });
}

Camera camera_of(const Pose& eye, std::int32_t field_of_view);

struct Model::State {
    std::shared_ptr<Mesh> mesh;  ///< never null; shared with level scenes that will show it
    std::vector<std::string> warnings;
    bool turns_to_eye = false;
};

Pose pose_of(const Vec3<World>& place);

/// Places a mesh by a pose and a frame of its motion.
PlacedMesh placed_at(const Mesh& mesh, const Pose& pose, std::int32_t frame);
/// The yaw of what turns to an eye that looks along a yaw.
inline Angle towards_eye(std::int32_t eye_yaw_256) {
    return angle_from_256(eye_yaw_256) + kHalfTurn;
}

}  // namespace oblong
