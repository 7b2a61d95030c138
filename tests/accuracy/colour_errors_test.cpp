// Errors of colour come from pixels that their dials change, and from no others.

#include <gtest/gtest.h>

#include <set>

#include "engine/files/files.h"
#include "tests/accuracy/scenes_fixture.h"
#include "tests/support/folders.h"
#include "tools/render/camera_list.h"

namespace oblong::test {
namespace {

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
                ASSERT_TRUE(!is_same || setting.light[i] < 0) << "no dial of light changes pixel " << i;
        }
    }
}

TEST(ColourErrors, DifferBetweenTheSettingsOfEachDialByEveryFigure) {
    const Scenes scenes(0);
    const MeasuredLevel level = watery_level(scenes, 2);
    std::vector<Dial> dials;
    for (const Dial& dial : all_dials())
        if (measure_of(dial) == Measure::LightColour || measure_of(dial) == Measure::PixelColour) dials.push_back(dial);
    const std::vector<MeasuredPlace> places{{level, scenes.palette, scenes.colormap}};
    Progress progress(false);
    const Report report = measure_all(make_configurations(dials), places, {1, 2, true}, progress);
    for (const Configurations::DialRows& rows : report.configurations.dials)
        for (const auto figure : {&ErrorSummary::rms, &ErrorSummary::p99, &ErrorSummary::max}) {
            std::set<double> values;
            for (const Configurations::Row& row : rows.rows)
                values.insert(summary_of(report.results[row.index].errors, rows.measure).*figure);
            EXPECT_GT(values.size(), 1u) << rows.dial->name << ": " << *values.begin() << " in each setting";
        }
}

}  // namespace
}  // namespace oblong::test
