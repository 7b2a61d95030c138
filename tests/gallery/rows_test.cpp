// What holds for every row of the gallery. What a row shows is tested beside what it shows: Row::test.

#include <set>
#include <sstream>

#include "tests/gallery/gallery_fixture.h"
#include "tools/gallery/page.h"
#include "tools/gallery/row.h"

namespace oblong::test {
namespace {

using GalleryRows = GalleryTest;

/// The values that a row starts with, and those with one parameter at its least or most.
std::vector<std::vector<std::int64_t>> ends_of_parameters(const Row& row) {
    std::vector<std::vector<std::int64_t>> all{start_values(row)};
    for (std::size_t i = 0; i < row.parameters.size(); ++i)
        for (const std::int64_t end : {row.parameters[i].least, row.parameters[i].most}) {
            all.push_back(start_values(row));
            all.back()[i] = end;
        }
    return all;
}

/// The values of a row's pictures: those that it starts with, with each choice of a first parameter that has choices.
std::vector<std::vector<std::int64_t>> values_of_choices(const Row& row) {
    std::vector<std::vector<std::int64_t>> all{start_values(row)};
    for (std::size_t choice = 1; choice < row.parameters[0].choices.size(); ++choice) all.push_back(all.front());
    for (std::size_t choice = 0; choice < row.parameters[0].choices.size(); ++choice)
        all[choice][0] = static_cast<std::int64_t>(choice);
    return all;
}

TEST(GalleryTable, RowsHaveDifferentIdsAndNamesThatFit) {
    std::set<std::string_view> ids, names;
    for (const Row& row : gallery_rows()) {
        EXPECT_TRUE(ids.insert(row.id).second) << row.id;
        EXPECT_TRUE(names.insert(row.name).second) << row.name;
        EXPECT_LE(text_width_px(row.name), 320 - 2 * kTextMargin_px) << row.name;
        EXPECT_EQ(row.id.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789-"), std::string_view::npos) << row.id;
    }
}

TEST(GalleryTable, NumbersOfARowDoNotTouch) {
    const std::array<Entry, 4> row{entry_of(-1234.5), entry_of(-0.25), entry_of(99999), entry_of(-123456)};
    for (const char* format : {"%4.0f", "%5.2f", "%7.3f"}) {
        std::istringstream words(row_text(row, format));
        EXPECT_EQ(std::distance(std::istream_iterator<double>(words), {}), 4) << row_text(row, format);
    }
}

TEST(GalleryTable, RowsNameTheirSeedAndFilesThatExist) {
    for (const Row& row : gallery_rows()) {
        ASSERT_FALSE(row.seeds.empty()) << row.id;
        EXPECT_TRUE(row.seeds.front() >= '1' && row.seeds.front() <= '5') << row.id << ": " << row.seeds;
        for (const std::string_view file : {row.source, row.test})
            EXPECT_TRUE(std::filesystem::is_regular_file(std::filesystem::path(test::source_folder()) / file))
                << row.id << ": " << file;
    }
}

TEST(GalleryTable, ParametersStartWithinTheirLimits) {
    for (const Row& row : gallery_rows())
        for (const Parameter& parameter : row.parameters) {
            EXPECT_LT(parameter.least, parameter.most) << row.id << ": " << parameter.name;
            EXPECT_GT(parameter.step, 0) << row.id << ": " << parameter.name;
            EXPECT_TRUE(parameter.least <= parameter.start && parameter.start <= parameter.most)
                << row.id << ": " << parameter.name;
        }
}

TEST_F(GalleryRows, FiguresAreAsExpectedWhateverTheParameters) {
    for (const Row& row : gallery_rows())
        for (const auto& values : ends_of_parameters(row)) {
            const Drawn drawn = draw(row, values);
            EXPECT_FALSE(drawn.figures.empty()) << row.id;
            EXPECT_TRUE(drawn.is_border_whole) << row.id;
            for (const Figure& figure : drawn.figures)
                EXPECT_TRUE(figure.agrees) << row.id << ": " << figure_text(figure);
        }
}

TEST_F(GalleryRows, EveryParameterChangesSomething) {
    for (const Row& row : gallery_rows())
        for (std::size_t i = 0; i < row.parameters.size(); ++i) {
            std::vector<std::int64_t> least = start_values(row), most = least;
            least[i] = row.parameters[i].least;
            most[i] = row.parameters[i].most;
            EXPECT_NE(draw(row, least).pixels, draw(row, most).pixels) << row.id << ": " << row.parameters[i].name;
        }
}

TEST_F(GalleryRows, PicturesAreTheSameEachTime) {
    for (const Row& row : gallery_rows())
        EXPECT_EQ(draw(row, start_values(row)).pixels, draw(row, start_values(row)).pixels) << row.id;
}

TEST_F(GalleryRows, StayRightInCanvasesOfOtherSizesAndAtTheCoarsestAccuracy) {
    Settings finest, coarsest;
    coarsest.accuracy = accuracy_of(Preset::Year1991);
    for (const ScreenMode& mode :
         {ScreenMode{}, ScreenMode{160, 100, {4, 3}}, ScreenMode{200, 320, {4, 3}}, ScreenMode{160, 100, {1, 2}},
          ScreenMode{1000, 100, {12, 5}}, ScreenMode{1024, 101, {1, 2}}, ScreenMode{255, 100, {3, 4}},
          ScreenMode{512, 150, {1, 2}}})
        for (const Settings& settings : {finest, coarsest})
            for (const Row& row : gallery_rows())
                for (const auto& values : values_of_choices(row)) {
                    const Drawn drawn = draw(row, values, mode, settings);
                    EXPECT_TRUE(drawn.is_border_whole) << row.id << " in " << mode.width_px << "x" << mode.height_px;
                    for (const Figure& figure : drawn.figures)
                        EXPECT_TRUE(figure.agrees)
                            << row.id << " in " << mode.width_px << ", 1/" << (1 << settings.accuracy.subpixel_bits)
                            << " pixel: " << figure_text(figure);
                }
}

TEST_F(GalleryRows, NothingIsDrawnOutsideOfTheSmallestCanvases) {
    for (const Row& row : gallery_rows())
        for (const ScreenMode& mode :
             {ScreenMode{8, 8, {4, 3}}, ScreenMode{8, 400, {1, 1}}, ScreenMode{80, 60, {4, 3}}})
            EXPECT_TRUE(draw(row, start_values(row), mode).is_border_whole) << row.id << " in " << mode.width_px;
}

/// What follows a mark in a text, up to a quotation mark, at each place.
std::set<std::string> all_after(const std::string& text, std::string_view mark) {
    std::set<std::string> found;
    for (std::size_t at = text.find(mark); at != std::string::npos; at = text.find(mark, at + 1)) {
        const std::size_t begin = at + mark.size();
        found.insert(text.substr(begin, text.find('"', begin) - begin));
    }
    return found;
}

TEST(GalleryPage, EveryPictureIsALinkAndEveryLinkLeadsSomewhere) {
    const std::vector<Row> rows = gallery_rows();
    std::vector<PageRow> shown;
    std::size_t pictures = 0;
    for (const Row& row : rows) {
        const std::string id(row.id);
        shown.push_back({row, {{id + ".png", "a"}, {id + "-1.png", "b"}}, {{}, {}}});
        pictures += 2;
    }
    const std::string page = index_page(shown, {});
    const std::set<std::string> ids = all_after(page, " id=\""), links = all_after(page, "<a href=\"#");
    EXPECT_EQ(all_after(page, "\"><img src=\"").size(), pictures);
    EXPECT_EQ(all_after(page, "<img src=\"").size(), pictures);
    for (const std::string& link : links) EXPECT_TRUE(ids.contains(link)) << link;
    EXPECT_EQ(links.size(), pictures + rows.size());
}

template <bool kIsWhole>
Figures long_figure(const RowInput&, Canvas&) {
    const std::string name = "a figure whose name is longer than a line of the canvas has room for, by";
    return {{name + (kIsWhole ? " far" : ""), "1"}};
}

TEST_F(GalleryRows, LinesOfFiguresAreWrappedNotCut) {
    Row row = gallery_rows().front();
    row.parameters.clear();
    row.draw = long_figure<true>;
    const Drawn whole = draw(row, {});
    row.draw = long_figure<false>;
    EXPECT_NE(draw(row, {}).pixels, whole.pixels) << "the last word shows";
}

}  // namespace
}  // namespace oblong::test
