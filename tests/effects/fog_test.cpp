// Distance fog against FitzQuake's formula in doubles, and its runs against the level of each pixel; height fog against
// sums along rays in doubles.
#include "engine/effects/fog.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>

#include "tests/support/random.h"

namespace oblong::test {

namespace {

InverseZ inverse_of(double z) {
    return fixed_of<InverseZ>(1 / z);
}

/// Parts of 63 that fog hides, before rounding.
double hidden_63(double density, double z, double start, double end) {
    const double reach = density / 64 * std::max(std::min(z, end) - start, 0.0);
    return 63 * (1 - std::exp(-reach * reach));
}

/// Of random depths and slopes: gentle, steep, through 0 and beyond what any polygon has.
LinearQuantity<InverseZ> random_inverse_z(std::mt19937_64& random) {
    const auto number = [&](int bits) { return static_cast<std::int64_t>(random()) >> (64 - bits); };
    const int bits = 8 + static_cast<int>(random() % 40);
    return {InverseZ::from_raw(number(1 + static_cast<int>(random() % 62))), InverseZ::from_raw(number(bits)),
            InverseZ::from_raw(number(bits))};
}

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

TEST(Fog, HidesWhatFitzQuakesFormulaSays) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 20'000; ++trial) {
        const double density = std::exp2(-8 + static_cast<double>(random() % 1000) / 100);
        const double start = trial % 2 ? static_cast<double>(random() % 300) : 0;
        const double end = trial % 3 ? 1 << 14 : static_cast<double>(300 + random() % 600);
        const double z = std::exp2(static_cast<double>(random() % 1300) / 100);
        const double hidden = hidden_63(density, z, start, end);
        if (std::abs(hidden - std::floor(hidden) - 0.5) < 0.001) continue;  // where the depths' rounding decides
        const FogDepths depths =
            make_fog_depths(fixed_of<FogDensity>(density), fixed_of<View>(start), fixed_of<View>(end));
        ASSERT_EQ(depths.level_at(inverse_of(z)), std::lround(hidden)) << density << ", " << start << ", " << z;
    }
}

TEST(Fog, DensitiesThatMeanNothingAreClear) {
    for (const FogDensity density : {FogDensity{}, fixed_of<FogDensity>(-1), FogDensity::lowest()}) {
        const FogDepths depths = make_fog_depths(density);
        for (const double z : {0.01, 1.0, 1e5}) EXPECT_EQ(depths.level_at(inverse_of(z)), 0);
    }
    const FogDepths thin = make_fog_depths(FogDensity::ulp()), thick = make_fog_depths(FogDensity::highest());
    EXPECT_EQ(thin.level_at(inverse_of(1e6)), 0);
    EXPECT_EQ(thick.level_at(inverse_of(1)), 63);
    const FogDepths before_eye = make_fog_depths(fixed_of<FogDensity>(0.1), fixed_of<View>(-500), fixed_of<View>(1000));
    EXPECT_EQ(before_eye.greatest_inverse_z,
              make_fog_depths(fixed_of<FogDensity>(0.1), {}, fixed_of<View>(1000)).greatest_inverse_z);
    const FogDepths reversed = make_fog_depths(fixed_of<FogDensity>(0.1), fixed_of<View>(500), fixed_of<View>(100));
    EXPECT_EQ(reversed.level_at(inverse_of(1e4)), 0);
}

/// At and beside each depth where a level begins, and from any guess.
TEST(Fog, ADepthHasTheLevelOfItsRoundedInverse) {
    std::mt19937_64 random(4);
    for (int i = 0; i < 60; ++i) {
        const View end = i % 3 == 0 ? View::from_int(1 + static_cast<std::int64_t>(random() % 3000)) : View::highest();
        const FogDepths depths =
            make_fog_depths(FogDensity::from_raw(static_cast<std::int64_t>(random() >> (i / 2 + 26))), {}, end);
        std::vector<View> places{View{}, View::ulp(), View::highest()};
        for (const View before : depths.greatest_before)
            for (int step = -2; step <= 2; ++step)
                if (before > View::from_raw(2) && before < View::highest())
                    places.push_back(before + View::from_raw(step));
        for (int j = 0; j < 50; ++j) places.push_back(View::from_raw(static_cast<std::int64_t>(random() >> (j + 13))));
        for (const View depth : places)
            ASSERT_EQ(depths.level_at(depth, static_cast<std::int32_t>(random() % FogTable::kLevels)),
                      depths.level_at(reciprocal<InverseZ>(depth)))
                << depth.raw;
    }
}

TEST(Fog, RunsHaveTheLevelOfEachPixelAndLeaveNoGap) {
    std::mt19937_64 random(2);
    for (int trial = 0; trial < 20'000; ++trial) {
        const FogDepths depths = make_fog_depths(FogDensity::from_raw(static_cast<std::int64_t>(random() >> 28)));
        const LinearQuantity<InverseZ> inverse_z = random_inverse_z(random);
        const auto first = static_cast<std::int32_t>(random() % 300);
        const Span span{static_cast<std::int32_t>(random() % 200), first,
                        first + 1 + static_cast<std::int32_t>(random() % 100)};
        std::vector<FogRun> runs;
        append_fog_runs(span, inverse_z, depths, runs);
        std::int32_t column = span.first;
        for (const FogRun& run : runs) {
            ASSERT_EQ(run.y, span.y);
            ASSERT_EQ(run.first, column);
            for (; column < run.end; ++column)
                ASSERT_EQ(run.level, depths.level_at(std::clamp(inverse_z.at(column, span.y), InverseZ{},
                                                                InverseZ::from_raw(std::int64_t{1} << 59))))
                    << trial << ", " << column;
        }
        ASSERT_EQ(column, span.end);
    }
}

TEST(Fog, ARunOfOneLevelIsNotCut) {
    const FogDepths depths = make_fog_depths(fixed_of<FogDensity>(0.05));
    std::vector<FogRun> runs;
    const LinearQuantity<InverseZ> wall{inverse_of(500), {}, {}};
    append_fog_runs({7, 10, 200}, wall, depths, runs);
    append_fog_runs({7, 200, 300}, wall, depths, runs);
    ASSERT_EQ(runs.size(), 1u);
    EXPECT_EQ(runs[0].end, 300);
    EXPECT_GT(runs[0].level, 0);
}

TEST(Fog, ColoursTheRunsThatAreNotClear) {
    FogTable table;
    for (std::size_t level = 0; level < 64; ++level)
        for (std::size_t colour = 0; colour < 256; ++colour)
            table.levels[level][colour] = static_cast<std::uint8_t>(colour + level);
    std::vector<std::uint8_t> pixels(40 * 3, 100);
    const std::vector<FogRun> runs{{{0, 0, 40}, 0}, {{1, 5, 9}, 3}, {{1, 9, 10}, 63}, {{2, 39, 40}, 1}};
    draw_fog(runs, table, {pixels.data(), 40, 3, 40});
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        const int expected = i >= 45 && i < 49 ? 103 : i == 49 ? 163 : i == 119 ? 101 : 100;
        EXPECT_EQ(pixels[i], expected) << i;
    }
}

TEST(Fog, TheSkyHasNoneHalfOrAll) {
    EXPECT_EQ(sky_fog_level(0), 0);
    EXPECT_EQ(sky_fog_level(128), 32);
    EXPECT_EQ(sky_fog_level(256), 63);
}

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
