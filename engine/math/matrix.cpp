#include "engine/math/matrix.h"

#include <algorithm>
#include <limits>
#include <utility>

#include "engine/base/table.h"
#include "engine/math/soft_float.h"
#include "engine/math/vec.h"

namespace oblong {
namespace {

/// A pivot that is smaller than the largest entry by more bits than this counts as a rounded 0.
constexpr int kSingularBits = 50;

/// The augmented matrix: the matrix and, right of it, the identity, which row operations turn into the inverse.
template <std::size_t N>
struct Elimination {
    std::array<std::array<SoftFloat, 2 * N>, N> rows{};

    explicit Elimination(const Matrix<N>& matrix) {
        for (std::size_t i = 0; i < N; ++i) {
            for (std::size_t j = 0; j < N; ++j)
                rows[i][j] = SoftFloat::from(matrix.rows[i][j].raw, -Entry::kFractionBits);
            rows[i][N + i] = SoftFloat::from(1, 0);
        }
    }

    /// The row from `column` down whose entry in that column is the largest.
    std::size_t pivot_row(std::size_t column) const {
        const auto size = [column](const auto& row) {
            const SoftFloat& entry = row[column];
            return std::pair{entry.is_zero() ? std::numeric_limits<int>::min() : entry.magnitude(),
                             detail::magnitude(entry.mantissa)};
        };
        const auto first = rows.begin() + static_cast<std::ptrdiff_t>(column);
        const auto largest =
            std::max_element(first, rows.end(), [&size](const auto& a, const auto& b) { return size(a) < size(b); });
        return as_size(largest - rows.begin());
    }

    void divide_row(std::size_t row, SoftFloat divisor) {
        for (SoftFloat& entry : rows[row]) entry = entry / divisor;
    }

    /// Subtracts multiples of the pivot's row from all others, so that they become 0 in `column`.
    void clear_column(std::size_t column) {
        for (std::size_t i = 0; i < N; ++i) {
            if (i == column) continue;
            const SoftFloat factor = rows[i][column];
            for (std::size_t j = 0; j < 2 * N; ++j) rows[i][j] = rows[i][j] - factor * rows[column][j];
        }
    }
};

template <std::size_t N>
int largest_magnitude(const Matrix<N>& matrix) {
    std::uint64_t largest = 0;
    for (const auto& row : matrix.rows)
        for (const Entry entry : row) largest = std::max(largest, detail::magnitude(entry.raw));
    return largest == 0 ? 0 : log2_floor(largest) + 1 - Entry::kFractionBits;
}

/// The right half as a matrix; none if an entry does not fit.
template <std::size_t N>
std::optional<Matrix<N>> right_half(const Elimination<N>& done) {
    Matrix<N> result;
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) {
            const std::optional<std::int64_t> raw = fixed_of(done.rows[i][N + j], Entry::kFractionBits);
            if (!raw) return std::nullopt;
            result.rows[i][j] = Entry::from_raw(*raw);
        }
    return result;
}

/// Gauss-Jordan elimination with partial pivoting.
template <std::size_t N>
std::optional<Matrix<N>> inverse_of(const Matrix<N>& matrix) {
    Elimination<N> elimination(matrix);
    const int smallest_pivot = largest_magnitude(matrix) - kSingularBits;
    for (std::size_t column = 0; column < N; ++column) {
        std::swap(elimination.rows[column], elimination.rows[elimination.pivot_row(column)]);
        const SoftFloat pivot = elimination.rows[column][column];
        if (pivot.is_zero() || pivot.magnitude() < smallest_pivot) return std::nullopt;
        elimination.divide_row(column, pivot);
        elimination.clear_column(column);
    }
    return right_half(elimination);
}

std::array<Entry, 4> row_of(const Vec3<Unit>& axis, Entry last) {
    return {convert<Entry>(axis.x), convert<Entry>(axis.y), convert<Entry>(axis.z), last};
}

}  // namespace

std::optional<Matrix3> inverse(const Matrix3& matrix) {
    return inverse_of(matrix);
}

std::optional<Matrix4> inverse(const Matrix4& matrix) {
    return inverse_of(matrix);
}

Matrix4 translation(const Vec3<Entry>& by) {
    Matrix4 result = Matrix4::identity();
    result.rows[0][3] = by.x;
    result.rows[1][3] = by.y;
    result.rows[2][3] = by.z;
    return result;
}

Matrix4 scaling(const Vec3<Entry>& by) {
    Matrix4 result = Matrix4::identity();
    result.rows[0][0] = by.x;
    result.rows[1][1] = by.y;
    result.rows[2][2] = by.z;
    return result;
}

Matrix4 view_matrix(const Basis& basis, const Vec3<World>& world_eye) {
    const auto row = [&world_eye](const Vec3<Unit>& axis) {
        return row_of(axis, convert<Entry>(-dot(world_eye, axis)));
    };
    return {{row(basis.right), row(basis.up), row(basis.forward), Matrix4::identity().rows[3]}};
}

std::optional<Matrix3> normal_matrix(const Matrix3& model_to_world) {
    const std::optional<Matrix3> inverted = inverse(model_to_world);
    if (!inverted) return std::nullopt;
    return inverted->transposed();
}

namespace {

std::array<Entry, 3> entries_of(const Vec3<Unit>& v) {
    return {convert<Entry>(v.x), convert<Entry>(v.y), convert<Entry>(v.z)};
}

}  // namespace

Matrix3 matrix_of_columns(const Vec3<Unit>& x, const Vec3<Unit>& y, const Vec3<Unit>& z) {
    return Matrix3{{entries_of(x), entries_of(y), entries_of(z)}}.transposed();
}

Matrix3 rotation_matrix(const EulerAngles& angles) {
    const Basis axes = view_basis(angles.yaw, angles.pitch, angles.roll);
    return matrix_of_columns(axes.forward, -axes.right, axes.up);
}

Matrix4 homogeneous(const Matrix3& linear) {
    Matrix4 result = Matrix4::identity();
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result.rows[i][j] = linear.rows[i][j];
    return result;
}

Matrix3 linear_part(const Matrix4& matrix) {
    Matrix3 result;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result.rows[i][j] = matrix.rows[i][j];
    return result;
}

Matrix4 model_matrix(const Vec3<World>& world_position, const Matrix3& rotation, const Vec3<Entry>& scale) {
    // translation * rotation * scaling, without their products by 0 and by 1.
    Matrix4 result = translation(convert<Entry>(world_position));
    const std::array scales{scale.x, scale.y, scale.z};
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j) result.rows[i][j] = multiply(rotation.rows[i][j], scales[j]);
    return result;
}

Matrix4 model_matrix(const Vec3<World>& world_position, const EulerAngles& angles, const Vec3<Entry>& scale) {
    return model_matrix(world_position, rotation_matrix(angles), scale);
}

}  // namespace oblong
