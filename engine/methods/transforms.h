#pragma once

#include <optional>

#include "engine/fixed/trig.h"
#include "engine/math/basis.h"
#include "engine/math/matrix.h"
#include "engine/math/vec.h"

namespace oblong {

/// A direction turned about an axis of length 1, counter-clockwise as seen with the axis pointing at the viewer (in
/// right-handed axes). Rodrigues' formula, rounded once.
Vec3<Unit> rotate_about_axis(const Vec3<Unit>& direction, const Vec3<Unit>& axis, Angle angle);
Basis rotate_about_axis(const Basis& basis, const Vec3<Unit>& axis, Angle angle);

/// Rotation by projection onto axes (Abrash): the direction's coordinates along right, up and forward.
Vec3<Unit> project_onto_axes(const Vec3<Unit>& direction, const Basis& axes);
/// The inverse: the direction with these coordinates along right, up and forward.
Vec3<Unit> sum_along_axes(const Vec3<Unit>& coordinates, const Basis& axes);

/// A rotation: w + x i + y j + z k of length 1, each component 2.30. q and -q are the same rotation.
struct Quaternion {
    Unit w = Unit::from_int(1), x, y, z;

    constexpr bool operator==(const Quaternion&) const = default;
};

/// The rotation by `angle` about an axis of length 1, counter-clockwise with the axis pointing at the viewer
/// (right-handed axes).
Quaternion quaternion_about_axis(const Vec3<Unit>& axis, Angle angle);

/// Hamilton's product of two rotations: first b, then a. Each component is rounded once.
Quaternion operator*(const Quaternion& a, const Quaternion& b);

/// The quaternion of length 1 in this direction; the zero quaternion stays zero.
Quaternion normalised(const Quaternion& quaternion);

Vec3<Unit> rotate(const Vec3<Unit>& direction, const Quaternion& rotation);
Basis rotate(const Basis& basis, const Quaternion& rotation);

/// The point of a homogeneous vector; none for a direction. Each coordinate saturates.
std::optional<Vec3<Entry>> point_of(const Vec4& homogeneous);

/// The rotation whose rows are right, up and forward: world directions to view directions.
Matrix3 rotation_matrix(const Basis& basis);

/// View to world, its inverse: the columns are the axes and the eye.
Matrix4 camera_matrix(const Basis& basis, const Vec3<World>& world_eye);

// Rotations as matrices: their columns are the images of the x, y and z axis. The entries are those of
// the functions above and of basis.h, bit for bit.

/// About an axis of length 1, counter-clockwise with the axis pointing at the viewer (right-handed axes).
Matrix3 rotation_matrix(const Vec3<Unit>& axis, Angle angle);
/// Of a quaternion of length 1.
Matrix3 rotation_matrix(const Quaternion& rotation);

/// The quaternion of the same rotation: the product of three, about z, y and x.
Quaternion quaternion_of(const EulerAngles& angles);

/// A model's point in the world, rounded once each coordinate; saturates.
Vec3<World> transformed_point(const Matrix4& model_to_world, const Vec3<World>& model_point);

/// view_basis() in a world with y up (x right, z forward, left-handed: the axes of an unturned view): yaw turns forward
/// toward +x, then pitch turns forward toward up, then roll turns right toward up. At 0, 0, 0 the axes are the world's.
Basis y_up_basis(Angle yaw, Angle pitch, Angle roll);

/// The axes before y_up_basis() rounds them: each component within 2^-57.
struct FineBasis {
    Vec3<Sine60> right, up, forward;
};
FineBasis y_up_fine_basis(Angle yaw, Angle pitch, Angle roll);

/// How far axes are from orthonormal: the largest |r_i . r_j - d_ij|. Unless it is 0, products of components do not
/// give lengths and angles (Muratori). Each axis is shorter than 1.6.
Sine60 orthonormal_flaw(const Basis& basis);

/// The largest flaw from rounding components to 2^-30, with a margin: 2^-26.
inline constexpr Sine60 kOrthonormalFlaw = Sine60::from_raw(std::int64_t{1} << (60 - 26));
bool is_orthonormal(const Basis& basis);

/// Orthonormal axes of the same handedness (Gram and Schmidt): forward keeps its direction, up loses its component
/// along forward, right follows from both. Zero or parallel axes are replaced by perpendicular ones.
Basis orthonormalised(const Basis& basis);

}  // namespace oblong
