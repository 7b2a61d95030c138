#include "engine/view/present_rect.h"

#include <algorithm>
#include <array>
#include <cstdlib>

#include "engine/base/table.h"

namespace oblong {
namespace {

constexpr std::int32_t kLargestWindowSide_px = 65'535;  // larger than any device; keeps the products below in 64 bits
constexpr std::int64_t kLargestUpscaledSide_px = 8192;  // a texture size that every renderer supports

struct Size {
    std::int64_t width, height;
};

std::int64_t rounded_quotient(std::int64_t numerator, std::int64_t denominator) {
    return (2 * numerator + denominator) / (2 * denominator);
}

// Width to height of a shown pixel.
Ratio pixel_shape(WindowSize window, const ScreenMode& mode, ShownAs shown_as) {
    if (shown_as == ShownAs::SquarePixels) return {1, 1};
    if (shown_as == ShownAs::OnDisplay) return mode.pixel();
    return Ratio{std::int64_t{window.width_px} * mode.height_px, std::int64_t{window.height_px} * mode.width_px};
}

// The largest size of this shape (width to height) within the window, rounded to whole pixels.
Size largest_fit(WindowSize window, Ratio shape) {
    const std::int64_t width = window.width_px, height = window.height_px;
    if (width * shape.denominator <= height * shape.numerator)
        return {width, std::max<std::int64_t>(1, rounded_quotient(width * shape.denominator, shape.numerator))};
    return {std::max<std::int64_t>(1, rounded_quotient(height * shape.numerator, shape.denominator)), height};
}

// As many whole rows as fit, and the exact width for them.
Size whole_rows(Size fit, const ScreenMode& mode, Ratio shape) {
    const std::int64_t rows_px = fit.height / mode.height_px * mode.height_px;
    const std::int64_t width = rounded_quotient(rows_px * shape.numerator, shape.denominator);
    return {std::clamp<std::int64_t>(width, 1, fit.width), rows_px};
}

// As many whole rows as fit, and the whole columns nearest to the shape that fit.
Size whole_pixels(Size fit, WindowSize window, const ScreenMode& mode, Ratio pixel) {
    const std::int64_t rows = fit.height / mode.height_px;
    const std::int64_t nearest = rounded_quotient(rows * pixel.numerator, pixel.denominator);
    const std::int64_t columns = std::clamp<std::int64_t>(nearest, 1, window.width_px / mode.width_px);
    return {columns * mode.width_px, rows * mode.height_px};
}

// The error of columns:rows as the shape of a pixel: +25 is 2.5 % too wide.
std::int32_t shape_error_permille(std::int64_t columns, std::int64_t rows, Ratio pixel) {
    const std::int64_t is = columns * pixel.denominator, should_be = rows * pixel.numerator;
    const std::int64_t error = rounded_quotient(1000 * std::abs(is - should_be), should_be);
    return static_cast<std::int32_t>(is < should_be ? -error : error);
}

std::int32_t next_whole_multiple(std::int64_t shown_px, std::int32_t mode_px) {
    const std::int64_t wanted = (shown_px + mode_px - 1) / mode_px;
    return static_cast<std::int32_t>(std::min(kLargestUpscaledSide_px / mode_px, wanted));
}

PresentRect centred(Size size, WindowSize window) {
    PresentRect rect;
    rect.width_px = static_cast<std::int32_t>(size.width);
    rect.height_px = static_cast<std::int32_t>(size.height);
    rect.x_px = (window.width_px - rect.width_px) / 2;
    rect.y_px = (window.height_px - rect.height_px) / 2;
    return rect;
}

std::string with_decimals(std::int64_t value, std::int64_t unit, int digits) {
    std::string fraction = std::to_string(value % unit);
    fraction.insert(0, as_size(digits) - fraction.size(), '0');
    return std::to_string(value / unit) + "." + fraction;
}

bool has_room_for_whole_pixels(Size fit, WindowSize window, const ScreenMode& mode) {
    return fit.height >= mode.height_px && window.width_px >= mode.width_px;
}

PresentRect blended(PresentRect rect, const ScreenMode& mode) {
    rect.upscale_x = next_whole_multiple(rect.width_px, mode.width_px);
    rect.upscale_y = next_whole_multiple(rect.height_px, mode.height_px);
    rect.is_blended =
        rect.upscale_x * mode.width_px != rect.width_px || rect.upscale_y * mode.height_px != rect.height_px;
    return rect;
}

PresentRect even(Size fit, WindowSize window, const ScreenMode& mode, Ratio pixel) {
    const Size size = whole_pixels(fit, window, mode, pixel);
    PresentRect rect = centred(size, window);
    rect.shape_error_permille = shape_error_permille(size.width / mode.width_px, size.height / mode.height_px, pixel);
    return rect;
}

}  // namespace

const char* name_of(Scaling scaling) {
    constexpr std::array<const char*, kScalingCount> names{"sharp", "rows", "even", "nearest"};
    return item(names, scaling);
}

PresentRect layout(WindowSize window, const ScreenMode& mode, ShownAs shown_as, Scaling scaling) {
    window.width_px = std::min(window.width_px, kLargestWindowSide_px);
    window.height_px = std::min(window.height_px, kLargestWindowSide_px);
    if (window.width_px <= 0 || window.height_px <= 0) return {};

    const Ratio pixel = pixel_shape(window, mode, shown_as).reduced();
    const Ratio picture = (pixel * Ratio{mode.width_px, mode.height_px}).reduced();
    const Size fit = largest_fit(window, picture);
    if (scaling == Scaling::Nearest) return centred(fit, window);
    if (has_room_for_whole_pixels(fit, window, mode)) {
        if (scaling == Scaling::Even) return even(fit, window, mode, pixel);
        if (scaling == Scaling::Rows) return blended(centred(whole_rows(fit, mode, picture), window), mode);
    }
    return blended(centred(fit, window), mode);
}

std::string describe(const PresentRect& rect, const ScreenMode& mode) {
    const std::int64_t columns = rect.width_px / mode.width_px, rows = rect.height_px / mode.height_px;
    if (columns * mode.width_px != rect.width_px || rows * mode.height_px != rect.height_px)
        return "x " + with_decimals(rounded_quotient(std::int64_t{rect.width_px} * 100, mode.width_px), 100, 2) +
               ", y " + with_decimals(rounded_quotient(std::int64_t{rect.height_px} * 100, mode.height_px), 100, 2);
    const std::string pair = std::to_string(columns) + ":" + std::to_string(rows);
    if (rect.shape_error_permille == 0) return pair;
    const char* sign = rect.shape_error_permille < 0 ? ", -" : ", +";
    return pair + sign + with_decimals(std::abs(rect.shape_error_permille), 10, 1) + " %";
}

}  // namespace oblong
