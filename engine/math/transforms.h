#pragma once

#include "engine/math/basis.h"
#include "engine/math/matrix.h"

namespace oblong {

/// Moves points, and leaves directions (w = 0) alone.
Matrix4 translation(const Vec3<Entry>& by);
/// Scales along the axes.
Matrix4 scaling(const Vec3<Entry>& by);

/// The rotation whose rows are right, up and forward: world directions to view directions.
Matrix3 rotation_matrix(const Basis& basis);

/// World to view: the rows are the axes, with -axis . eye at their end (Princeton, course notes).
Matrix4 view_matrix(const Basis& basis, const Vec3<World>& world_eye);
/// View to world, the inverse of it: the columns are the axes and the eye.
Matrix4 camera_matrix(const Basis& basis, const Vec3<World>& world_eye);

/// The matrix for the normals of a model whose points are transformed by `model_to_world`: the transpose of the
/// inverse. `model_to_world` itself would do for rotation and uniform scale only. None for a singular matrix.
std::optional<Matrix3> normal_matrix(const Matrix3& model_to_world);

}  // namespace oblong
