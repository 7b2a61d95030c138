#pragma once

#include "engine/math/basis.h"
#include "engine/math/matrix.h"

namespace oblong {

/// What moves points, and leaves directions (w = 0) alone.
Matrix4 translation(const Vec3<Entry>& by);
/// What stretches along the axes.
Matrix4 scaling(const Vec3<Entry>& by);

/// The rotation whose rows are right, up and forward: world directions to view directions.
Matrix3 rotation_matrix(const Basis& basis);

/// World to view: the rows are the axes, with -axis . eye at their end (Princeton, course notes).
Matrix4 view_matrix(const Basis& basis, const Vec3<World>& world_eye);
/// View to world, the inverse of it: the columns are the axes and the eye.
Matrix4 camera_matrix(const Basis& basis, const Vec3<World>& world_eye);

/// What turns the normals of a model that `model_to_world` turns, stretches and shears: the transpose of the inverse.
/// The matrix itself would keep them normal under rotation and uniform scale alone. None for a singular matrix.
std::optional<Matrix3> normal_matrix(const Matrix3& model_to_world);

}  // namespace oblong
