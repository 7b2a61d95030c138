// The report's parts, each alone.

#include <gtest/gtest.h>

#include "tools/accuracy/configurations.h"
#include "tools/accuracy/heat_map.h"
#include "tools/accuracy/notes.h"

namespace oblong {
namespace {

TEST(Configurations, AreAllDialsAloneAroundTheDefaultAndThePresets) {
    const Configurations all = make_configurations(all_dials());
    EXPECT_EQ(all.accuracies[all.default_index], Accuracy{});
    EXPECT_EQ(all.presets.size(), 5u);
    for (const Configurations::DialRows& rows : all.dials)
        for (std::size_t i = 0; i < rows.rows.size(); ++i) {
            Accuracy expected;
            if (rows.dial->name == "texel-bound") expected.texturing = Texturing::BoundedTexels;
            rows.dial->set(expected, rows.dial->settings[i].value);
            EXPECT_EQ(all.accuracies[rows.rows[i].index], expected) << rows.dial->name << '=' << rows.rows[i].name;
            EXPECT_TRUE(all.is_timed[rows.rows[i].index] || !rows.dial->changes_work);
            EXPECT_TRUE(all.is_counted[rows.rows[i].index]);
            if (rows.is_below_bound) expected.texturing = Texturing::Exact;
            EXPECT_EQ(all.accuracies[rows.rows[i].alone], expected) << rows.dial->name << '=' << rows.rows[i].name;
        }
}

/// A report of one dial whose settings have these errors.
Report report_with(std::vector<ErrorSummaries> errors) {
    Report report;
    report.configurations = make_configurations(std::span(dial_named("sine"), 1));
    report.results.resize(report.configurations.accuracies.size());
    for (std::size_t i = 0; i < errors.size(); ++i)
        report.results[report.configurations.dials[0].rows[i].alone].errors = errors[i];
    return report;
}

ErrorSummaries displaced(double rms, double max, double texels = 1) {
    ErrorSummaries errors;
    errors.displacement = {1, rms, rms, max};
    errors.texels = {1, texels, texels, texels};
    return errors;
}

TEST(Notes, SayWhereMoreAccuracyIsFurtherOffAndWhy) {
    const Report report = report_with({displaced(2, 3), displaced(1, 4), displaced(1.01, 5), displaced(1.5, 6, 0.5),
                                       displaced(1.8, 5), displaced(0.1, 0.2)});
    const std::vector<std::string> notes = notes_on_order(report, report.configurations.dials[0]);
    ASSERT_EQ(notes.size(), 2u) << "one for 1.01 to 1.5, one for 1.5 to 1.8; 1 per cent is none";
    EXPECT_NE(notes[0].find("quarter1024 is further off than cordic16"), std::string::npos) << notes[0];
    EXPECT_NE(notes[0].find("By texels it is closer"), std::string::npos) << notes[0];
    EXPECT_NE(notes[1].find("Its largest error is smaller"), std::string::npos) << notes[1];
}

TEST(Numbers, HaveThreeDigits) {
    EXPECT_EQ(number_text(0), "0");
    EXPECT_EQ(number_text(0.0213456), "0.0213");
    EXPECT_EQ(number_text(0.1), "0.100");
    EXPECT_EQ(number_text(375.4), "375");
    EXPECT_EQ(number_text(12446), "12,400");
    EXPECT_EQ(number_text(-12446789), "-12,400,000");
    EXPECT_EQ(number_text(0.000001), "below 0.00001");
    EXPECT_EQ(number_text(9.999), "10.0");
    EXPECT_EQ(number_text(999.7), "1,000");
}

TEST(HeatMap, BrightensWithTheLogarithmOfTheError) {
    const std::vector<std::uint8_t> pixels = heat_pixels({-1, 0, 1.0F / 256, 0.5F, 64, 1000}, Measure::Displacement);
    EXPECT_EQ(pixels, (std::vector<std::uint8_t>{0, 1, 1, 128, 255, 255}));
    const Palette palette = heat_palette();
    int before = -1;
    for (std::size_t i = 1; i < 256; ++i) {
        EXPECT_GE(luminance_1000(palette.colours[i]), before) << i;
        before = luminance_1000(palette.colours[i]);
    }
}

}  // namespace
}  // namespace oblong
