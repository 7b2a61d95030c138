#include "engine/mesh/placed_mesh.h"

#include <algorithm>
#include <array>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/math/matrix.h"

namespace oblong {

namespace {

/// Object space to world.
Matrix4 matrix_of(const PlacedMesh& placed) {
    return model_matrix(placed.position, EulerAngles{placed.yaw, placed.pitch, placed.roll}, placed.scale);
}

bool has_small_entries(const Matrix4& matrix) {
    std::uint64_t entries = 0;
    for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column) entries |= magnitude(matrix.rows[row][column]);
    return entries >> (Entry::kFractionBits + 4) == 0;
}

/// The rotation of normals, if the scale is equal along all axes: they keep their length.
std::optional<std::array<Vec3<Unit>, 3>> rotation_of_normals(const PlacedMesh& placed) {
    const Vec3<Entry>& scale = placed.scale;
    if (scale.x != scale.y || scale.x != scale.z) return std::nullopt;
    const Matrix3 rotation = rotation_matrix(EulerAngles{placed.yaw, placed.pitch, placed.roll});
    const auto row = [&](std::size_t i) {
        const auto& [x, y, z] = rotation.rows[i];
        return convert<Unit>(Vec3<Entry>{x, y, z});
    };
    return std::array{row(0), row(1), row(2)};
}

const MeshFrame& frame_at(const Mesh& mesh, std::uint32_t number) {
    return mesh.frames[std::min<std::size_t>(number, mesh.frames.size() - 1)];
}

/// The middle of an interval and half its length.
struct Interval {
    Entry middle, half;

    Interval(World low, World high)
        : middle((convert<Entry>(low) + convert<Entry>(high)) / 2),
          half(std::max(convert<Entry>(high) - convert<Entry>(low), Entry{}) / 2) {}
};

}  // namespace

const MeshFrame& frame_of(const PlacedMesh& placed) {
    return frame_at(*placed.mesh, placed.frame);
}

const MeshFrame& next_frame_of(const PlacedMesh& placed) {
    return frame_at(*placed.mesh, placed.next_frame);
}

std::optional<MeshTransform> make_mesh_transform(const PlacedMesh& placed) {
    const Vec3<Entry>& scale = placed.scale;
    if (scale.x <= Entry{} || scale.y <= Entry{} || scale.z <= Entry{}) return std::nullopt;
    const Matrix4 to_world = matrix_of(placed);
    const std::optional<Matrix3> normals = normal_matrix(linear_part(to_world));
    const std::optional<Matrix4> to_object = inverse(to_world);
    if (!normals || !to_object) return std::nullopt;
    return MeshTransform{to_world, *normals, *to_object, has_small_entries(to_world), rotation_of_normals(placed)};
}

LevelBox world_box(const PlacedMesh& placed) {
    const MeshFrame &from = frame_of(placed), &to = next_frame_of(placed);
    return world_box(matrix_of(placed), {from.mins, from.maxs}, {to.mins, to.maxs});
}

LevelBox world_box(const Matrix4& to_world, const MeshBox& from, const MeshBox& to) {
    const std::array sides{Interval(std::min(from.mins.x, to.mins.x), std::max(from.maxs.x, to.maxs.x)),
                           Interval(std::min(from.mins.y, to.mins.y), std::max(from.maxs.y, to.maxs.y)),
                           Interval(std::min(from.mins.z, to.mins.z), std::max(from.maxs.z, to.maxs.z))};
    LevelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const auto& row = to_world.rows[axis];
        Entry middle = row[3], half;
        for (std::size_t side = 0; side < 3; ++side) {
            middle = saturating_sum(middle, multiply(row[side], sides[side].middle));
            const Entry reach = multiply(row[side], sides[side].half);
            half = saturating_sum(half, reach < Entry{} ? -std::max(reach, -Entry::highest()) : reach);
        }
        box.mins[axis] = box_coordinate(floor_of(saturating_sum(middle, -half)) - 1);
        box.maxs[axis] = box_coordinate(floor_of(saturating_sum(middle, half)) + 2);
    }
    return box;
}

TurningShape turning_shape(const PlacedMesh& placed) {
    const MeshFrame &from = frame_of(placed), &to = next_frame_of(placed);
    return {placed.position, placed.scale, {MeshBox{from.mins, from.maxs}, MeshBox{to.mins, to.maxs}}};
}

/// The sum of the largest coordinates along the axes is at least the distance of any vertex from the mesh's origin.
LevelBox turning_box(const TurningShape& shape) {
    const auto& [from, to] = shape.boxes;
    const auto farthest = [](World a, World b, World c, World d) {
        return std::max({WorldWide{}, convert<WorldWide>(absolute(a)), convert<WorldWide>(absolute(b)),
                         convert<WorldWide>(absolute(c)), convert<WorldWide>(absolute(d))});
    };
    const WorldWide sum = farthest(from.mins.x, from.maxs.x, to.mins.x, to.maxs.x) +
                          farthest(from.mins.y, from.maxs.y, to.mins.y, to.maxs.y) +
                          farthest(from.mins.z, from.maxs.z, to.mins.z, to.maxs.z);
    const Entry scale = std::max({shape.scale.x, shape.scale.y, shape.scale.z});
    const std::int64_t reach = floor_of(multiply(scale, convert<Entry>(sum))) + 3;
    const std::array position{shape.position.x, shape.position.y, shape.position.z};
    LevelBox box;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        const std::int64_t middle = floor_of(position[axis]);
        box.mins[axis] = box_coordinate(middle - reach);
        box.maxs[axis] = box_coordinate(middle + reach + 1);
    }
    return box;
}

}  // namespace oblong
