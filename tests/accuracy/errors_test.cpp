// Errors of the hard scenes' frames: their order along the dial of perspective, and the bound.
// Errors of colour come from pixels that their dials change, and from no others.

#include <gtest/gtest.h>

#include <set>

#include "engine/frame/frame.h"
#include "engine/frame/frame_record.h"
#include "engine/frame/workspace.h"
#include "engine/measure/texel_error.h"
#include "tests/accuracy/scenes_fixture.h"
#include "tools/render/camera_list.h"

namespace oblong::test {

namespace {

/// The displacements of all frames of some levels.
ErrorSummary displacement(const std::vector<MeasuredLevel>& levels, const Colormap& colormap,
                          const Accuracy& accuracy) {
    std::vector<float> all;
    for (const MeasuredLevel& level : levels) {
        LevelFrames frames(level, colormap);
        for (const Camera& camera : level.cameras) {
            TexelErrorMeter meter(level.exact, level.models, camera, kMeasuredMode);
            for (const TexelError& error : meter.measure(frames.record(camera, accuracy)))
                if (error.is_measured()) all.push_back(error.pixels);
        }
    }
    return summarize_errors(std::move(all));
}

TEST(HardScenes, MoreDivisionsAlongThePerspectiveDialMeanASmallerError) {
    const Scenes scenes(1);
    double coarser = 1e9;
    for (const Texturing texturing :
         {Texturing::Affine, Texturing::Every32, Texturing::Every16, Texturing::Every8, Texturing::Exact}) {
        const double rms = displacement(scenes.levels, scenes.colormap, textured_by(texturing)).rms;
        EXPECT_LT(rms, coarser) << static_cast<int>(texturing);
        coarser = rms;
    }
    EXPECT_LT(coarser, 0.02) << "a division a pixel is not exact";
}

TEST(HardScenes, BoundedStaysWithinItsBound) {
    const Scenes scenes(100);
    for (const MeasuredLevel& level : scenes.levels)
        for (const std::int32_t bound_256 : {32, 96, 512}) {
            Accuracy accuracy = textured_by(Texturing::Bounded);
            accuracy.pixel_bound_256 = bound_256;
            const ErrorSummary error = displacement({level}, scenes.colormap, accuracy);
            EXPECT_LE(error.max, bound_256 / 256.0) << level.name;
        }
}

/// Whether a texture coordinate is the last of a surface, which begins and ends at whole 16 texels.
bool is_at_edge(double texel, double rounding) {
    return std::abs(texel - std::round(texel / 16) * 16) <= rounding;
}

/// How far off a texel may be by its coordinates' rounding, texels of level 0: engine/fixed/README.md, in both
/// coordinates, whose gradients are those of the mip level; in rooms of 4,096 units.
double texel_budget(double z, int mip) {
    constexpr double kPixels = 320 / 2 + 200 / 2 + 3, kTexels = 4096;
    const double sampled = z * kPixels * 0x1p-30 + 0x1p-13;
    return std::sqrt(2) * (std::ldexp(sampled, mip) + z * 2 * kTexels * kPixels * 0x1p-45 + kTexels * 0x1p-26);
}

/// What is left at a division a pixel is rounding, by engine/fixed/README.md, or the last texel of a surface: of a
/// pixel whose centre lies beyond the face's edge by no more than its corners are rounded by.
TEST(HardScenes, WhatExactTexelsAreOffByIsRoundingOrTheEdgeOfASurface) {
    const Scenes scenes(100);
    int edges = 0;
    for (const MeasuredLevel& level : scenes.levels) {
        LevelFrames frames(level, scenes.colormap);
        for (const Camera& camera : level.cameras) {
            const reference::Camera exact = reference::make_camera(reference_view(camera, kMeasuredMode));
            TexelErrorMeter meter(level.exact, level.models, camera, kMeasuredMode);
            const FrameRecord& record = frames.record(camera, textured_by(Texturing::Exact));
            const std::vector<TexelError> errors = meter.measure(record);
            for (std::size_t i = 0; i < errors.size(); ++i) {
                const PixelRecord& pixel = record.pixels[i];
                if (!errors[i].is_measured()) continue;
                const reference::PlaneView plane(level.exact, level.exact.face(pixel.face.number()), {}, exact);
                const double z =
                    1 / plane.inverse_z({static_cast<double>(i % 320) + 0.5, static_cast<double>(i / 320) + 0.5});
                const double rounding = texel_budget(z, pixel.mip);
                if (errors[i].texels <= rounding) continue;
                const double u = number_of(pixel.u), v = number_of(pixel.v);
                ASSERT_TRUE(is_at_edge(u, rounding) || is_at_edge(v, rounding))
                    << level.name << " u " << u << " v " << v << " mip " << int{pixel.mip} << " z " << z << " off "
                    << errors[i].texels << " allowed " << rounding;
                ++edges;
            }
        }
    }
    EXPECT_GT(edges, 0);
}

/// Pixels that no face covers, whatever is shown there.
std::int64_t uncovered_pixels(const Scenes& scenes, const Accuracy& accuracy) {
    const MeasuredLevel& level = scenes.named("slivers");
    FrameWorkspace work(level.level, kMeasuredMode);
    Settings settings;
    settings.accuracy = accuracy;
    std::vector<std::uint8_t> pixels(pixel_count(kMeasuredMode.width_px, kMeasuredMode.height_px));
    std::int64_t count = 0;
    for (const Camera& camera : level.cameras) {
        draw_frame({level.level, scenes.colormap, level.models}, camera, kMeasuredMode, settings, work,
                   {pixels.data(), kMeasuredMode.width_px, kMeasuredMode.height_px, kMeasuredMode.width_px});
        count += pixels_of(work.view.claims.void_spans);
        for (const TornSpan& torn : work.view.claims.torn) count += torn.span.end - torn.span.first;
    }
    return count;
}

TEST(HardScenes, LooseEdgesGapeUnlessTheyAreMended) {
    const Scenes scenes(100);
    Accuracy open;
    open.mends_t_junctions = false;
    EXPECT_GT(uncovered_pixels(scenes, open), 5);
    EXPECT_EQ(uncovered_pixels(scenes, {}), 0);
}

/// The demo level seen by cameras of its list before which there is much water: liquids are drawn in waves and unlit.
MeasuredLevel watery_level(const Scenes& scenes, std::size_t most_cameras) {
    const std::string assets = build_folder() + "/assets/";
    const std::vector<std::uint8_t> bsp = read_file(assets + "demo.bsp");
    MeasuredLevel level = make_measured_level(
        "demo level", "", bsp, parse_cameras(read_file(assets + "demo_cameras.csv"), Degrees::from_int(90)));
    LevelFrames frames(level, scenes.colormap);
    std::vector<Camera> watery;
    for (const Camera& camera : level.cameras) {
        const FrameRecord& record = frames.record(camera, {});
        const auto liquid = std::count_if(record.pixels.begin(), record.pixels.end(), [&](const PixelRecord& pixel) {
            return !pixel.face.is_none() &&
                   level.exact.face(pixel.face.number()).material == reference::Material::Liquid;
        });
        if (liquid > 5000 && watery.size() < most_cameras) watery.push_back(camera);
    }
    level.cameras = watery;
    return level;
}

TEST(ColourErrors, AreOfPixelsThatTheDialsOfTheMeasureChange) {
    const Scenes scenes(0);
    const MeasuredLevel level = watery_level(scenes, 2);
    const reference::Palette palette = reference_palette(scenes.palette);
    ASSERT_EQ(level.cameras.size(), 2u);
    LevelFrames frames(level, scenes.colormap);
    for (const Camera& camera : level.cameras) {
        const FrameTruth truth = make_frame_truth(frames, camera, palette, 1);
        std::vector<PixelErrors> errors;
        std::vector<std::vector<std::uint8_t>> pictures;
        for (const Dial& dial : all_dials())
            for (const DialSetting& setting : dial.settings) {
                if (measure_of(dial) != Measure::LightColour) continue;
                Accuracy accuracy;
                dial.set(accuracy, setting.value);
                const FrameRecord& record = frames.record(camera, accuracy);
                errors.push_back(measure_frame({level, camera, truth, palette, record, frames.pixels()}));
                pictures.emplace_back(frames.pixels().begin(), frames.pixels().end());
            }
        for (std::size_t i = 0; i < pictures[0].size(); ++i) {
            const bool is_same = std::all_of(pictures.begin(), pictures.end(),
                                             [&](const auto& picture) { return picture[i] == pictures[0][i]; });
            for (const PixelErrors& setting : errors)
                ASSERT_TRUE(!is_same || item(setting, Measure::LightColour)[i] < 0)
                    << "no dial of light changes pixel " << i;
        }
    }
}

TEST(ColourErrors, DifferBetweenTheSettingsOfEachDialByEveryFigure) {
    const Scenes scenes(0);
    const MeasuredLevel level = watery_level(scenes, 2);
    const std::vector<MeasuredLevel> hard_scenes = make_hard_scenes(scenes.palette, 1);
    const MeasuredLevel& coloured = hard_scenes.back();
    ASSERT_EQ(coloured.name, "coloured lamps");
    std::vector<Dial> dials;
    for (const Dial& dial : all_dials())
        if (measure_of(dial) == Measure::LightColour || measure_of(dial) == Measure::PixelColour) dials.push_back(dial);
    const std::vector<MeasuredPlace> places{{level, scenes.palette, scenes.colormap},
                                            {coloured, scenes.palette, scenes.colormap}};
    const Report report = measure_all(make_configurations(dials), places, {1, 2, true});
    for (const Configurations::DialRows& rows : report.configurations.dials)
        for (const auto figure : {&ErrorSummary::rms, &ErrorSummary::p99, &ErrorSummary::max}) {
            std::set<double> values;
            const std::size_t place = rows.dial->name == "colours" ? 1 : 0;
            for (const Configurations::Row& row : rows.rows)
                values.insert(item(report.results[row.index].by_level[place], rows.measure).*figure);
            EXPECT_GT(values.size(), 1u) << rows.dial->name << ": " << *values.begin() << " in each setting";
        }
}

}  // namespace

}  // namespace oblong::test
