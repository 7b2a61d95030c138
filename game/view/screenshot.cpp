#include "game/view/screenshot.h"

#include <algorithm>
#include <exception>
#include <filesystem>
#include <stdexcept>
#include <vector>

#include "engine/io/files.h"
#include "engine/pictures/picture.h"
#include "engine/view/present_rect.h"

namespace oblong {
namespace {

constexpr WindowSize kLargestExact{1600, 1200};
constexpr std::int64_t kLargestSide_px = 8192;
constexpr int kMostScreenshots = 1000;

struct Multiples {
    std::int32_t x, y;
};

// Columns and rows of the block that shows a pixel in its right shape; zeros if even the smallest makes a picture too
// large.
Multiples exact_multiples(const ScreenMode& mode) {
    const Ratio pixel = mode.pixel();
    const std::int64_t width = pixel.numerator * mode.width_px, height = pixel.denominator * mode.height_px;
    if (width > kLargestSide_px || height > kLargestSide_px) return {0, 0};
    const std::int64_t times =
        std::max<std::int64_t>(1, std::min(kLargestExact.width_px / width, kLargestExact.height_px / height));
    return {static_cast<std::int32_t>(pixel.numerator * times), static_cast<std::int32_t>(pixel.denominator * times)};
}

std::vector<std::uint8_t> enlarged(Framebuffer picture, Multiples by) {
    const std::int32_t width = picture.width_px * by.x, height = picture.height_px * by.y;
    std::vector<std::uint8_t> pixels;
    pixels.reserve(pixel_count(width, height));
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) pixels.push_back(picture.row(y / by.y)[x / by.x]);
    return pixels;
}

std::string stem(int number) {
    const std::string digits = std::to_string(number);
    return "oblong-" + std::string(3 - digits.size(), '0') + digits;
}

int first_free_number() {
    for (int number = 0; number < kMostScreenshots; ++number)
        if (!std::filesystem::exists(stem(number) + ".png")) return number;
    throw std::runtime_error("there are 1000 screenshots already");
}

void save(const std::string& file, Framebuffer picture, Multiples by, const Palette& palette) {
    write_file(file,
               encode_indexed_png(enlarged(picture, by), picture.width_px * by.x, picture.height_px * by.y, palette));
}

}  // namespace

std::string save_screenshots(Framebuffer picture, const Palette& palette, const ScreenMode& mode) {
    try {
        const std::string name = stem(first_free_number());
        save(name + ".png", picture, {1, 1}, palette);
        const Multiples by = exact_multiples(mode);
        if (by.x == 0) return "{screenshot} Saved " + name + ".png";
        const std::string exact =
            "-" + std::to_string(mode.width_px * by.x) + "x" + std::to_string(mode.height_px * by.y) + ".png";
        save(name + exact, picture, by, palette);
        return "{screenshot} Saved " + name + ".png and " + exact;
    } catch (const std::exception& error) {
        return std::string("{screenshot} Not saved: ") + error.what();
    }
}

}  // namespace oblong
