#include "tests/support/pictures.h"

#include <algorithm>
#include <fstream>
#include <string>

#include "tests/files/png_writer.h"
#include "tests/support/folders.h"

namespace oblong::test {

namespace {

/// The project's palette where it is built already, else greys: 3 bytes a colour.
std::vector<std::uint8_t> shown_colours() {
    std::vector<std::uint8_t> colours = read_file_bytes(build_folder() + "/assets/palette.lmp");
    if (colours.size() == 768) return colours;
    colours.clear();
    for (int i = 0; i < 256; ++i) colours.insert(colours.end(), 3, static_cast<std::uint8_t>(i));
    return colours;
}

void write_picture(const std::string& path, std::span<const std::uint8_t> pixels, std::size_t width,
                   const std::vector<std::uint8_t>& colours) {
    PngBytes rows;
    for (std::size_t i = 0; i < pixels.size(); ++i) {
        if (i % width == 0) rows.push_back(0);
        rows.push_back(pixels[i]);
    }
    const PngBytes header =
        png_header(static_cast<std::uint32_t>(width), static_cast<std::uint32_t>(pixels.size() / width), 8, 3);
    const PngBytes file = png_of_rows(header, rows, {{"PLTE", colours}});
    std::ofstream(path, std::ios::binary)
        .write(reinterpret_cast<const char*>(file.data()), static_cast<std::streamsize>(file.size()));
}

/// Where the pictures of the test that runs are written, numbered in the order in which they fail.
std::string next_place() {
    static int number = 0;
    const testing::TestInfo* const test = testing::UnitTest::GetInstance()->current_test_info();
    std::string name = std::string(test->test_suite_name()) + "." + test->name() + "-" + std::to_string(++number);
    std::replace(name.begin(), name.end(), '/', '_');
    const std::string folder = build_folder() + "/failed_pictures";
    std::filesystem::create_directories(folder);
    return folder + "/" + name;
}

}  // namespace

testing::AssertionResult same_picture(std::span<const std::uint8_t> found, std::span<const std::uint8_t> expected,
                                      std::size_t width) {
    if (found.size() != expected.size())
        return testing::AssertionFailure() << found.size() << " pixels, expected " << expected.size();
    std::vector<std::uint8_t> differs;
    for (std::size_t i = 0; i < found.size(); ++i) differs.push_back(found[i] == expected[i] ? 0 : 255);
    const auto first = std::find(differs.begin(), differs.end(), 255);
    if (first == differs.end()) return testing::AssertionSuccess();
    const std::string place = next_place();
    write_picture(place + "-found.png", found, width, shown_colours());
    write_picture(place + "-expected.png", expected, width, shown_colours());
    std::vector<std::uint8_t> black_and_white(768);
    std::fill(black_and_white.end() - 3, black_and_white.end(), std::uint8_t{255});
    write_picture(place + "-difference.png", differs, width, black_and_white);
    const auto at = static_cast<std::size_t>(first - differs.begin());
    return testing::AssertionFailure() << std::count(differs.begin(), differs.end(), 255)
                                       << " pixels differ, first column " << at % width << ", row " << at / width
                                       << ": " << int{found[at]} << ", expected " << int{expected[at]}
                                       << ". Pictures: " << place << "-{found,expected,difference}.png";
}

}  // namespace oblong::test
