// The report's parts, each alone.

#include <gtest/gtest.h>

#include <set>

#include "tools/accuracy/base64.h"
#include "tools/accuracy/configurations.h"
#include "tools/accuracy/heat_map.h"
#include "tools/accuracy/notes.h"
#include "tools/accuracy/numbers.h"
#include "tools/accuracy/svg.h"

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

TEST(ParetoFront, IsWhatNoOtherBeatsInBoth) {
    // Index, error, cost.
    const std::vector<Tradeoff> front =
        pareto_front({{0, 5, 1}, {1, 3, 2}, {2, 4, 3}, {3, 1, 4}, {4, 1, 5}, {5, 3, 2.5}});
    ASSERT_EQ(front.size(), 3u);
    EXPECT_EQ(front[0].index, 0u);
    EXPECT_EQ(front[1].index, 1u);
    EXPECT_EQ(front[2].index, 3u);
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
    EXPECT_EQ(short_number_text(0.1), "0.1");
    EXPECT_EQ(short_number_text(10), "10");
    EXPECT_EQ(short_number_text(300), "300");
}

/// The vectors of RFC 4648.
TEST(Base64, IsThatOfTheStandard) {
    const auto encoded = [](const std::string& text) {
        return base64({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()});
    };
    EXPECT_EQ(encoded(""), "");
    EXPECT_EQ(encoded("f"), "Zg==");
    EXPECT_EQ(encoded("fo"), "Zm8=");
    EXPECT_EQ(encoded("foo"), "Zm9v");
    EXPECT_EQ(encoded("foobar"), "Zm9vYmFy");
    EXPECT_EQ(encoded("\xff\xfe\xfd"), "//79");
}

TEST(Svg, EscapesWhatIsNoText) {
    EXPECT_EQ(escaped("a<b>&\"c\""), "a&lt;b&gt;&amp;&quot;c&quot;");
    EXPECT_EQ(escaped("\u00b5s \u2030"), "\u00b5s \u2030");
    EXPECT_EQ(escaped("a\xff\xc3"), "a??");
    EXPECT_EQ(escaped("a\nb"), "a b");
}

TEST(LogAxis, PlacesPowersOfTenEvenly) {
    const LogAxis axis(0.01, 100, 0, 400);
    EXPECT_NEAR(axis.place(0.01), 0, 1e-9);
    EXPECT_NEAR(axis.place(1), 200, 1e-9);
    EXPECT_NEAR(axis.place(100), 400, 1e-9);
    EXPECT_NEAR(axis.place(1e9), 400, 1e-9);
    EXPECT_EQ(axis.ticks().size(), 5u);
}

TEST(LogAxis, LabelsNarrowRangesToo) {
    for (const auto& [least, greatest] : {std::pair{290.0, 720.0}, {100.0, 103.0}, {0.5, 9.0}, {1e-5, 300.0}}) {
        const std::vector<double> ticks = LogAxis(least, greatest, 0, 700).ticks();
        EXPECT_GE(ticks.size(), 2u) << least;
        EXPECT_LE(ticks.size(), 10u) << least;
        for (const double tick : ticks) EXPECT_TRUE(tick >= least && tick <= greatest) << tick;
    }
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
