// Height fog against sums along rays in doubles.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "engine/effects/fog.h"
#include "tests/support/random.h"

namespace oblong::test {

namespace {

constexpr double kDensity = 0.1;

FogDepths depths() {
    return make_fog_depths(fixed_of<FogDensity>(kDensity));
}

/// A plane in a view, and low fog.
struct FoggyView {
    Basis axes;
    LinearQuantity<InverseZ> inverse_z;
    double eye_height, top, fade;

    /// 63 parts of what fog hides at a pixel: the density at 1,000 points of the ray, added up.
    double hidden_63(std::int32_t column, std::int32_t row) const {
        const double z = 1 / number_of(inverse_z.at(column, row));
        const double right = (column + 0.5 - 160) / 160, up = -(row + 0.5 - 100) / 100 * 0.75;
        const double rise = number_of(axes.right.z) * right + number_of(axes.up.z) * up + number_of(axes.forward.z);
        constexpr int kPoints = 1000;
        double sum = 0;
        for (int i = 0; i < kPoints; ++i) {
            const double depth = top - (eye_height + rise * z * (i + 0.5) / kPoints);
            sum += fade > 0 ? std::clamp(depth / fade, 0.0, 1.0) : depth > 0;
        }
        const double reach = kDensity / 64 * z * sum / kPoints;
        return 63 * (1 - std::exp(-reach * reach));
    }
    std::vector<FogRun> runs(const Span& span) const {
        const ViewDirections directions =
            make_view_directions(axes, make_projection(ScreenMode{}, Degrees::from_int(90)));
        const HeightFogView view =
            make_height_fog_view({fixed_of<World>(top), fixed_of<World>(fade)}, point_at(0, 0, eye_height), directions);
        std::vector<FogRun> found;
        append_height_fog_runs(span, inverse_z, view, depths(), found);
        return found;
    }
};

/// Surfaces from 16 to 3,000 units away along the row, walls and floors.
FoggyView random_view(std::mt19937& random) {
    const auto up_to = [&](double most) { return most * static_cast<double>(random() % 100'000) / 100'000; };
    const auto inverse = [&] {
        const double most = up_to(3000);
        return std::ldexp(1 / (16 + up_to(1) * most), 44);
    };
    const double left = inverse(), right = random() % 3 == 0 ? left : inverse();
    const auto per_column = static_cast<std::int64_t>((right - left) / 320);
    FoggyView view;
    const Angle pitch = Angle::from_bam(random_below(random, 16000) - 8000);
    view.axes = view_basis(random_angle(random), pitch, random() % 2 ? Angle{} : random_angle(random));
    view.inverse_z = {InverseZ::from_raw(static_cast<std::int64_t>(left)), InverseZ::from_raw(per_column), {}};
    view.eye_height = up_to(400) - 200;
    view.top = up_to(400) - 200;
    view.fade = random() % 8 == 0 ? 0 : up_to(200);
    return view;
}

}  // namespace

TEST(HeightFog, IsTheSumAlongEachRay) {
    std::mt19937 random(1);
    int wrong = 0;
    for (int trial = 0; trial < 100; ++trial) {
        const auto row = static_cast<std::int32_t>(random() % 200);
        const FoggyView view = random_view(random);
        std::int32_t column = 0;
        for (const FogRun& run : view.runs({row, 0, 320})) {
            ASSERT_EQ(run.first, column);
            for (; column < run.end; ++column) {
                const double off = std::abs(run.level - view.hidden_63(column, row));
                ASSERT_LT(off, 1) << trial << ": " << column << ", " << row << " level " << run.level;
                wrong += off > 0.55;  // half a level is rounding, the rest what 1,000 points are off the integral
            }
        }
        ASSERT_EQ(column, 320);
    }
    EXPECT_LT(wrong, 100 * 320 / 1000) << "where a level changes and changes back within 16 pixels";
}

TEST(HeightFog, AboveItIsClearAndInItIsDistanceFog) {
    std::mt19937 random(2);
    for (int trial = 0; trial < 300; ++trial) {
        FoggyView view = random_view(random);
        view.top = -40'000;
        const std::vector<FogRun> above = view.runs({50, 3, 320});
        ASSERT_EQ(above.size(), 1u);
        EXPECT_EQ(above[0].level, 0);
        view.top = 40'000;
        for (const FogRun& run : view.runs({50, 3, 320}))
            for (const std::int32_t column : {run.first + 0, run.end - 1})
                ASSERT_EQ(run.level, depths().level_at(view.inverse_z.at(column, 50)));
    }
}

TEST(HeightFog, ExtremesAreHeld) {
    const std::int64_t most = std::int64_t{1} << 62;
    for (const std::int64_t origin : {-most, std::int64_t{0}, std::int64_t{1}, most})
        for (const std::int64_t step : {-most, std::int64_t{-1}, std::int64_t{0}, most})
            for (const double height : {-500'000.0, 0.0, 500'000.0})
                for (const double fade : {-10.0, 0.0, 1e-3, 500'000.0}) {
                    FoggyView view{view_basis({}, Angle::from_bam(-16384), {}), {}, -height, height, fade};
                    view.inverse_z = {InverseZ::from_raw(origin), InverseZ::from_raw(step), {}};
                    std::int32_t pixels = 0;
                    for (const FogRun& run : view.runs({199, 0, 4096})) {
                        ASSERT_EQ(run.first, pixels);
                        ASSERT_TRUE(run.level >= 0 && run.level <= 63);
                        pixels = run.end;
                    }
                    ASSERT_EQ(pixels, 4096);
                }
}

}  // namespace oblong::test
