#include "engine/math/matrix.h"

#include <gtest/gtest.h>

#include "engine/methods/transforms.h"
#include "tests/support/random.h"

namespace oblong::test::matrix_test {
namespace {

__extension__ using Int128 = __int128;

template <std::size_t N>
using Integers = std::array<std::array<std::int64_t, N>, N>;

/// The determinant of the matrix without row `row` and column `column`; expansion along the first row.
template <std::size_t N>
Int128 determinant(const Integers<N>& m) {
    if constexpr (N == 1) {
        return m[0][0];
    } else {
        Int128 sum = 0;
        for (std::size_t column = 0; column < N; ++column) {
            Integers<N - 1> minor{};
            for (std::size_t i = 1; i < N; ++i)
                for (std::size_t j = 0, to = 0; j < N; ++j)
                    if (j != column) minor[i - 1][to++] = m[i][j];
            const Int128 term = m[0][column] * determinant<N - 1>(minor);
            sum += column % 2 == 0 ? term : -term;
        }
        return sum;
    }
}

/// Cramer's rule: entry (i, j) of the inverse is the cofactor of (j, i) over the determinant.
template <std::size_t N>
Int128 cofactor(const Integers<N>& m, std::size_t row, std::size_t column) {
    Integers<N> replaced = m;
    for (std::size_t j = 0; j < N; ++j) replaced[row][j] = j == column ? 1 : 0;
    return determinant<N>(replaced);
}

template <std::size_t N>
Matrix<N> matrix_of(const Integers<N>& integers) {
    Matrix<N> result;
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) result.rows[i][j] = Entry::from_int(integers[i][j]);
    return result;
}

/// Every entry of `got` is within a step of the exact quotient cofactor 2^32 / determinant.
template <std::size_t N>
void expect_inverse(const Matrix<N>& got, const Integers<N>& of, Int128 det) {
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j) {
            const Int128 off = got.rows[i][j].raw * det - cofactor<N>(of, j, i) * (Int128{1} << 32);
            ASSERT_TRUE((off < 0 ? -off : off) <= (det < 0 ? -det : det)) << i << " " << j;
        }
}

template <std::size_t N>
void expect_inverses_of_random_integers(int count, int range) {
    std::mt19937 random(1);
    for (int k = 0; k < count; ++k) {
        Integers<N> integers{};
        for (auto& row : integers)
            for (auto& entry : row) entry = random_below(random, 2 * range + 1) - range;
        const Int128 det = determinant<N>(integers);
        const auto got = inverse(matrix_of<N>(integers));
        ASSERT_EQ(got.has_value(), det != 0);
        if (got) expect_inverse<N>(*got, integers, det);
        if (testing::Test::HasFatalFailure()) return;
    }
}

TEST(HardCaseT6, InversesAreWithinAStepOfCramersRuleOrSingular) {
    for (const int range : {1'000, 2}) {  // of small integers many are singular
        expect_inverses_of_random_integers<3>(20'000, range);
        expect_inverses_of_random_integers<4>(20'000, range);
    }
}

TEST(HardCaseT6, RotationWithUnequalScaleHasAnInverseThatIsNotItsTranspose) {
    const Basis basis = view_basis(Angle::from_bam(5'000), Angle::from_bam(700), Angle::from_bam(-90));
    Matrix3 model = rotation_matrix(basis);
    for (Entry& entry : model.rows[1]) entry = Entry::from_raw(entry.raw * 4);
    const auto undone = inverse(model);
    ASSERT_TRUE(undone);
    EXPECT_NE(*undone, model.transposed());
    const Matrix3 both = model * *undone;
    for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t j = 0; j < 3; ++j)
            EXPECT_LE(std::abs(both.rows[i][j].raw - Matrix3::identity().rows[i][j].raw), 8) << i << " " << j;
}

TEST(HardCaseT6, DependentRowsAndVanishingScalesAreSingular) {
    EXPECT_FALSE(inverse(Matrix4{}));
    EXPECT_FALSE(inverse(scaling({Entry::from_int(1), Entry{}, Entry::from_int(1)})));
    const Entry third = divide<Entry>(Entry::from_int(1), Entry::from_int(3));
    Matrix3 dependent = Matrix3::identity();
    dependent.rows[1] = {third, third, third};
    dependent.rows[2] = {third + third, third + third, third + third};
    EXPECT_FALSE(inverse(dependent));
    EXPECT_FALSE(inverse(scaling({Entry::ulp(), Entry::ulp(), Entry::ulp()}))) << "its inverse does not fit";
}

/// What rounding leaves of a pivot that should be 0 is no pivot, even where its reciprocal would fit: entries fill the
/// format, and the last row is a mean of the others, exactly.
TEST(HardCaseT6, HugeDependentRowsAreSingular) {
    std::mt19937_64 random(7);
    for (int i = 0; i < 20'000; ++i) {
        Matrix4 dependent;
        for (std::size_t j = 0; j < 4; ++j) {
            std::int64_t mean = 0;
            for (const std::size_t row : {0u, 1u, 2u}) {
                const auto multiple_of_4 = static_cast<std::int64_t>(random() & ~std::uint64_t{3});
                dependent.rows[row][j] = Entry::from_raw(multiple_of_4);
                mean += multiple_of_4 / (row == 2 ? 2 : 4);
            }
            dependent.rows[3][j] = Entry::from_raw(mean);
        }
        ASSERT_FALSE(inverse(dependent)) << i;
    }
}

TEST(Matrix, ProductAppliesTheRightOneFirst) {
    const auto by = [](std::int64_t x, std::int64_t y, std::int64_t z) {
        return Vec3<Entry>{Entry::from_int(x), Entry::from_int(y), Entry::from_int(z)};
    };
    const Vec4 point{Entry::from_int(1), Entry::from_int(2), Entry::from_int(3)};
    EXPECT_EQ(*point_of(scaling(by(2, 2, 2)) * translation(by(10, 0, 0)) * point), by(22, 4, 6));
    EXPECT_EQ(*point_of(translation(by(10, 0, 0)) * scaling(by(2, 2, 2)) * point), by(12, 4, 6));
}

TEST(Matrix, ProductOfIntegersIsExact) {
    const Integers<3> a{{{1, 2, 3}, {4, 5, 6}, {7, 8, 9}}}, b{{{-1, 0, 2}, {3, 1, 0}, {0, 5, -4}}};
    EXPECT_EQ(matrix_of<3>(a) * matrix_of<3>(b), matrix_of<3>({{{5, 17, -10}, {11, 35, -16}, {17, 53, -22}}}));
}

TEST(Matrix, HugeEntriesSaturate) {
    Matrix3 huge;
    for (auto& row : huge.rows) row = {Entry::highest(), Entry::highest(), Entry::highest()};
    EXPECT_EQ((huge * huge).rows[0][0], Entry::highest());
}

TEST(HomogeneousVector, DividesByItsLastComponentAndDirectionsAreNoPoints) {
    const Vec4 doubled{Entry::from_int(2), Entry::from_int(-4), Entry::from_int(6), Entry::from_int(2)};
    EXPECT_EQ(*point_of(doubled), (Vec3<Entry>{Entry::from_int(1), Entry::from_int(-2), Entry::from_int(3)}));
    EXPECT_FALSE(point_of({Entry::from_int(1), {}, {}, Entry{}}));
}

TEST(ViewMatrix, GivesThePointsThatToViewGives) {
    std::mt19937 random(3);
    for (int i = 0; i < 5'000; ++i) {
        const Vec3<World> eye = random_world(random, 4), p = random_world(random, 4);
        const Basis basis = random_axes(random);
        const Vec4 got = view_matrix(basis, eye) * homogeneous(p);
        const Vec3<View> expected = to_view(p, eye, basis);
        for (const auto& [is, exact] : {std::pair{got.x, expected.x}, {got.y, expected.y}, {got.z, expected.z}})
            ASSERT_LE(std::abs(is.raw - exact.raw * 65536), 32768 + 4);
    }
}

}  // namespace
}  // namespace oblong::test::matrix_test
