#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <numbers>
#include <numeric>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <vector>

#include "engine/draw/drawing.h"
#include "engine/fixed/trig.h"
#include "engine/frame/frame.h"
#include "engine/level/level.h"
#include "engine/math/matrix.h"
#include "engine/measure/exact.h"
#include "engine/surface/colormap.h"
#include "engine/view/screen.h"

namespace oblong {

/// A number as a double: also the engine's.
struct FigureNumber {
    double value;

    template <class Value>
    requires std::is_arithmetic_v<Value> FigureNumber(Value number) : value(static_cast<double>(number)) {}
    template <class Int, int Frac>
    FigureNumber(Fixed<Int, Frac> number) : value(number_of(number)) {}
};

/// A number in a row: the expected value, computed from the seed or by an independent method, and the value found by
/// the engine for this picture.
struct Figure {
    /// Two numbers that agree within `tolerance`; both are written with `decimals`.
    Figure(std::string what, FigureNumber expects, FigureNumber finds, FigureNumber tolerance, int decimals = 3);
    /// Two counts, or two texts, that are equal.
    Figure(std::string what, std::int64_t expects, std::int64_t finds);
    Figure(std::string what, std::string expects, std::string finds);
    Figure(std::string what, std::string expects, std::string finds, bool agree);
    /// A measurement without an expected value: a time, a count of operations.
    Figure(std::string what, std::string finds) : Figure(std::move(what), "", std::move(finds), true) {}
    Figure(std::string what, std::int64_t finds) : Figure(std::move(what), std::to_string(finds)) {}

    std::string name, expected, found;
    bool agrees = false;
};

/// A number of a row that keys change; with `choices`, the index of a name.
struct Parameter {
    Parameter(std::string what, std::int64_t from, std::int64_t to, std::int64_t by, std::int64_t starts)
        : name(std::move(what)), least(from), most(to), step(by), start(starts) {}
    Parameter(std::string what, std::vector<std::string> names, std::int64_t starts = 0)
        : Parameter(std::move(what), 0, std::ssize(names) - 1, 1, starts) {
        choices = std::move(names);
    }

    std::string name;
    std::int64_t least, most, step, start;
    std::vector<std::string> choices;
};
/// A choice of the rows of a table, by their names.
template <class Table>
Parameter choice_of(std::string name, const Table& table, std::int64_t start = 0) {
    std::vector<std::string> choices;
    for (const auto& row : table) choices.emplace_back(row.name);
    return {std::move(name), std::move(choices), start};
}

/// The data that rows draw with.
struct GalleryAssets {
    const Level& demo_level;
    const Colormap& colormap;  ///< with its palette
    TextColours text;
};

/// The input of a row's picture, which depends on nothing else.
struct RowInput {
    const GalleryAssets& assets;
    ScreenMode mode;
    Settings settings;                 ///< accuracy, and whether the projection corrects the aspect
    std::vector<std::int64_t> values;  ///< of the row's parameters, in their order
    std::int64_t time_ms = 0;

    double number(std::size_t parameter) const { return static_cast<double>(values[parameter]); }
    /// The value of a parameter in degrees, in radians.
    double radians(std::size_t parameter) const { return number(parameter) * std::numbers::pi / 180; }
    Angle angle(std::size_t parameter) const { return degrees_to_angle(Degrees::from_int(values[parameter])); }
    /// The index of the palette's nearest colour.
    std::uint8_t colour(Rgb8 wanted) const { return nearest_colour(assets.colormap.palette, wanted); }
    std::uint8_t colour(int red, int green, int blue) const {
        const auto channel = [](int value) { return static_cast<std::uint8_t>(value); };
        return colour(Rgb8{channel(red), channel(green), channel(blue)});
    }
};

/// The first three are shown below the picture, all are in the index page.
using Figures = std::vector<Figure>;

class Canvas;

/// A subject that the seeds name, with its scene. `draw` gets a canvas of the mode's size and of one colour; the
/// gallery then writes the name over the top kHeader_px rows and figures over the lowest kFooter_px.
struct Row {
    std::string_view id;  ///< of its files: "lines-bresenham"
    Figures (*draw)(const RowInput& input, Canvas& canvas);
    std::vector<Parameter> parameters;
    // From rows.txt.
    std::string_view name = {};                ///< in the field's terms
    std::string_view seeds = {};               ///< "2 Lab", "3 Notes: Lines; 4 Princeton: Projection"
    std::string_view source = {};              ///< the file that does it: "engine/raster/lines.h"
    std::string_view test = {};                ///< the file that tests it: "tests/raster/lines_test.cpp"
    std::vector<std::string_view> notes = {};  ///< short sentences
};

/// The values that a row's parameters start with.
std::vector<std::int64_t> start_values(const Row& row);
/// A value of a parameter as text: its choice's name, or the number.
std::string value_text(const Parameter& parameter, std::int64_t value);

inline constexpr std::int32_t kHeader_px = 12, kFooter_px = 34;

/// Draws a row with its name above and its figures below; shows the parameter `chosen`.
Figures draw_row(const Row& row, const RowInput& input, std::size_t chosen, Framebuffer canvas);
/// A figure in one line: "140  column of the far face's corner".
std::string figure_text(const Figure& figure);

// Conversions between the engine's numbers and doubles, in which rows compute.

/// A point or a direction in doubles.
using reference::Vec;
/// Radians.
inline constexpr double kDegree = std::numbers::pi / 180;
/// A point of the world, from units.
Vec3<World> world_point(double x, double y, double z);
Vec3<World> world_point(const Vec& place);
/// A direction of length 1; not of the zero vector.
Vec3<Unit> unit_vector(const Vec& direction);
/// Numbers of a matrix: one, a triple, and a point or (w = 0) a direction in four coordinates.
Entry entry_of(double value);
inline Vec3<Entry> entries_of(const Vec& v) {
    return {entry_of(v.x), entry_of(v.y), entry_of(v.z)};
}
inline Vec4 homogeneous_of(const Vec& v, double w = 1) {
    return {entry_of(v.x), entry_of(v.y), entry_of(v.z), entry_of(w)};
}

/// A number as text: "%.3f" or another format.
std::string decimal_text(FigureNumber value, const char* format = "%.3f");
/// Several of them, with `between` between them: the widest numbers do not touch.
std::string decimals_text(std::initializer_list<FigureNumber> values, const char* format, const char* between = " ");
inline std::string triple_text(const Vec& v, const char* format, const char* between = " ") {
    return decimals_text({v.x, v.y, v.z}, format, between);
}
/// A row of a matrix; the last column moves points and may need more room.
inline std::string row_text(const std::array<Entry, 4>& row, const char* format, const char* last_format = nullptr) {
    return decimals_text({row[0], row[1], row[2]}, format) + " " +
           decimal_text(row[3], last_format ? last_format : format);
}
/// A matrix below its title.
std::vector<std::string> matrix_lines(std::string title, const Matrix4& matrix, const char* format,
                                      const char* last_format = nullptr);

/// The number of different elements of two lists of equal length.
template <class Element>
std::int64_t count_differences(const std::vector<Element>& a, const std::vector<Element>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), std::int64_t{0}, std::plus<>(), std::not_equal_to<>());
}

/// The largest difference between entries of two matrices.
template <std::size_t N>
double largest_difference(const Matrix<N>& a, const Matrix<N>& b) {
    double most = 0;
    for (std::size_t i = 0; i < N; ++i)
        for (std::size_t j = 0; j < N; ++j)
            most = std::max(most, std::abs(number_of(a.rows[i][j]) - number_of(b.rows[i][j])));
    return most;
}

/// All rows, in the order of the seeds, with their texts.
std::vector<Row> gallery_rows();

// The rows of each subject, without texts, from one file each in tools/gallery/rows/.
std::vector<Row> aspect_rows();
std::vector<Row> clipping_rows();
std::vector<Row> cyclic_overlap_rows();
std::vector<Row> hidden_surface_rows();
std::vector<Row> inspection_rows();
std::vector<Row> line_rows();
std::vector<Row> projection_matrix_rows();
std::vector<Row> projection_rows();
std::vector<Row> shading_rows();
std::vector<Row> stage_rows();
std::vector<Row> texture_rows();
std::vector<Row> transform_rows();
std::vector<Row> triangle_rows();
std::vector<Row> vector_rows();
std::vector<Row> view_rows();

}  // namespace oblong
