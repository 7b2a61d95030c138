#pragma once

#include <array>
#include <cstdint>
#include <optional>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/fixed.h"
#include "engine/fixed/trig.h"
#include "engine/math/basis.h"
#include "engine/math/vec.h"

namespace oblong {

/// An entry of a matrix: 32.32. Matrices hold distances of thousands of units next to inverses of scales and viewplane
/// distances, thousandths of a unit: 16.16 would leave three digits for either.
using Entry = Fixed<std::int64_t, 32>;

/// A homogeneous vector: the point (x / w, y / w, z / w), or for w = 0 a direction.
struct Vec4 {
    Entry x, y, z, w = Entry::from_int(1);
    constexpr bool operator==(const Vec4&) const = default;
};

/// N rows of N entries, for column vectors: (A B) v = A (B v).
template <std::size_t N>
struct Matrix {
    std::array<std::array<Entry, N>, N> rows{};

    static constexpr Matrix identity() {
        Matrix result;
        for (std::size_t i = 0; i < N; ++i) result.rows[i][i] = Entry::from_int(1);
        return result;
    }

    constexpr Matrix transposed() const {
        Matrix result;
        for (std::size_t i = 0; i < N; ++i)
            for (std::size_t j = 0; j < N; ++j) result.rows[j][i] = rows[i][j];
        return result;
    }

    /// One row times a column: each product is rounded to nearest, the sum saturates.
    constexpr Entry row_times(std::size_t row, const std::array<Entry, N>& column) const {
        std::int64_t sum = 0;
        for (std::size_t i = 0; i < N; ++i) sum = saturating_sum(sum, multiply(rows[row][i], column[i]).raw);
        return Entry::from_raw(sum);
    }

    constexpr bool operator==(const Matrix&) const = default;
};

using Matrix3 = Matrix<3>;
using Matrix4 = Matrix<4>;

/// Each entry is within N / 2 steps of the exact product, or saturates.
template <std::size_t N>
constexpr Matrix<N> operator*(const Matrix<N>& a, const Matrix<N>& b) {
    const Matrix<N> columns = b.transposed();
    Matrix<N> result;
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) result.rows[i][j] = a.row_times(i, columns.rows[j]);
    return result;
}

constexpr Vec3<Entry> operator*(const Matrix3& m, const Vec3<Entry>& v) {
    const std::array column{v.x, v.y, v.z};
    return {m.row_times(0, column), m.row_times(1, column), m.row_times(2, column)};
}

constexpr Vec4 operator*(const Matrix4& m, const Vec4& v) {
    const std::array column{v.x, v.y, v.z, v.w};
    return {m.row_times(0, column), m.row_times(1, column), m.row_times(2, column), m.row_times(3, column)};
}

/// The inverse; if the condition number is below 2^20, each entry is within one step of the exact one. None if the
/// matrix is singular (rows linearly dependent within 2^-50 of the largest entry) or an entry of the inverse does not
/// fit.
std::optional<Matrix3> inverse(const Matrix3& matrix);
std::optional<Matrix4> inverse(const Matrix4& matrix);

/// Moves points, and leaves directions (w = 0) unchanged.
Matrix4 translation(const Vec3<Entry>& by);
/// Scales along the axes.
Matrix4 scaling(const Vec3<Entry>& by);

/// World to viewspace: the rows are the axes, followed by -axis . eye (Princeton, course notes).
Matrix4 view_matrix(const Basis& basis, const Vec3<World>& world_eye);

/// The matrix for normals of a model whose points are transformed by `model_to_world`: its inverse transpose, as
/// scaling may be non-uniform. None for a singular matrix.
std::optional<Matrix3> normal_matrix(const Matrix3& model_to_world);

/// An orientation, as in levels and cameras: yaw counter-clockwise from +x seen from above, pitch positive looking
/// down, roll positive leaning right. Applied in the order roll (about x), pitch (about y), yaw (about z), each about
/// the world's axis: the matrix is Rz(yaw) Ry(pitch) Rx(roll).
struct EulerAngles {
    Angle yaw, pitch, roll;
    constexpr bool operator==(const EulerAngles&) const = default;
};

/// The matrix with these columns, the images of the x, y and z axis.
Matrix3 matrix_of_columns(const Vec3<Unit>& x, const Vec3<Unit>& y, const Vec3<Unit>& z);
/// A rotation; the entries equal those of view_basis(), bit for bit.
Matrix3 rotation_matrix(const EulerAngles& angles);

/// A linear map as an affine one without translation.
Matrix4 homogeneous(const Matrix3& linear);
/// A point as a homogeneous vector with w = 1.
template <class Number>
Vec4 homogeneous(const Vec3<Number>& point) {
    return {convert<Entry>(point.x), convert<Entry>(point.y), convert<Entry>(point.z)};
}
/// The upper left 3x3, which transforms directions.
Matrix3 linear_part(const Matrix4& matrix);

/// Model to world: the product of scaling along the model's axes, rotation and translation, applied in this order. A
/// negative scale mirrors, which reverses the winding of triangles. Scales are below 2^30; entries saturate.
Matrix4 model_matrix(const Vec3<World>& world_position, const Matrix3& rotation, const Vec3<Entry>& scale);
Matrix4 model_matrix(const Vec3<World>& world_position, const EulerAngles& angles, const Vec3<Entry>& scale);

}  // namespace oblong
