#include "tools/gallery/row.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <span>
#include <stdexcept>

#include "engine/base/table.h"
#include "engine/draw/drawing.h"
#include "engine/surface/palette.h"
#include "tools/gallery/canvas.h"
#include "tools/gallery/texts.h"

namespace oblong {

namespace {

std::string with_decimals(double value, int decimals) {
    return decimal_text(value, ("%." + std::to_string(decimals) + "f").c_str());
}

std::string parameter_text(const Row& row, std::span<const std::int64_t> values, std::size_t chosen) {
    const Parameter& parameter = row.parameters[chosen];
    std::string text = "< " + parameter.name + ": " + value_text(parameter, values[chosen]) + " >";
    if (row.parameters.size() > 1)
        text += "  (" + std::to_string(chosen + 1) + " of " + std::to_string(row.parameters.size()) + ")";
    return text;
}

/// Takes the lines of a text up to an empty one.
std::vector<std::string_view> take_paragraph(std::string_view& text) {
    std::vector<std::string_view> lines;
    while (!text.empty()) {
        const std::string_view line = text.substr(0, text.find('\n'));
        text.remove_prefix(std::min(line.size() + 1, text.size()));
        if (line.empty()) break;
        lines.push_back(line);
    }
    return lines;
}

/// Takes the row with the id at the start of a paragraph, and sets its texts.
Row with_text(const std::vector<std::string_view>& lines, std::map<std::string_view, Row>& rows) {
    auto found = rows.extract(lines.front());
    if (!found || lines.size() < 5) throw std::logic_error("no row for the text of " + std::string(lines.front()));
    Row& row = found.mapped();
    row.name = lines[1], row.seeds = lines[2], row.source = lines[3], row.test = lines[4];
    row.notes.assign(lines.begin() + 5, lines.end());
    return row;
}

}  // namespace

Figure::Figure(std::string what, std::string expects, std::string finds, bool agree)
    : name(std::move(what)), expected(std::move(expects)), found(std::move(finds)), agrees(agree) {}

Figure::Figure(std::string what, FigureNumber expects, FigureNumber finds, FigureNumber tolerance, int decimals)
    : Figure(std::move(what), with_decimals(expects.value, decimals), with_decimals(finds.value, decimals),
             std::abs(expects.value - finds.value) <= tolerance.value) {}

Figure::Figure(std::string what, std::string expects, std::string finds)
    : name(std::move(what)), expected(std::move(expects)), found(std::move(finds)), agrees(expected == found) {}

Figure::Figure(std::string what, std::int64_t expects, std::int64_t finds)
    : Figure(std::move(what), std::to_string(expects), std::to_string(finds)) {}

std::vector<std::int64_t> start_values(const Row& row) {
    std::vector<std::int64_t> values;
    for (const Parameter& parameter : row.parameters) values.push_back(parameter.start);
    return values;
}

std::string value_text(const Parameter& parameter, std::int64_t value) {
    return parameter.choices.empty() ? std::to_string(value) : item(parameter.choices, value);
}

std::string figure_text(const Figure& figure) {
    std::string text = figure.found;
    if (!figure.agrees)
        text = "WRONG: " + text + ", expected " + figure.expected;
    else if (!figure.expected.empty() && figure.expected != figure.found)
        text += " (expected " + figure.expected + ")";
    return text + "  " + figure.name;
}

Figures draw_row(const Row& row, const RowInput& input, std::size_t chosen, Framebuffer pixels) {
    Canvas canvas(input, pixels);
    canvas.fill(kGround);
    Figures figures = row.draw(input, canvas);
    const TextColours colours = input.assets.text;
    fill_area(canvas, {0, 0, canvas.width_px, kHeader_px}, colours.dark);
    fill_area(canvas, {0, canvas.height_px - kFooter_px, canvas.width_px, kFooter_px}, colours.dark);
    const std::int32_t width_px = canvas.width_px - 2 * kTextMargin_px;
    draw_text(canvas, kTextMargin_px, 2, row.name, colours);
    std::vector<std::string> texts;
    if (!row.parameters.empty()) texts.push_back(parameter_text(row, input.values, chosen));
    for (const Figure& figure : figures) texts.push_back(figure_text(figure));
    std::int32_t y = canvas.height_px - kFooter_px + 2;
    for (const std::string& text : texts)
        for (const std::string_view line : lines_of(text, width_px)) {
            if (y + kLineHeight_px > canvas.height_px) return figures;
            draw_text(canvas, kTextMargin_px, y, line, colours);
            y += kLineHeight_px;
        }
    return figures;
}

Vec3<World> world_point(double x, double y, double z) {
    return {fixed_of<World>(x), fixed_of<World>(y), fixed_of<World>(z)};
}

Vec3<World> world_point(const Vec& place) {
    return world_point(place.x, place.y, place.z);
}

Vec3<Unit> unit_vector(const Vec& direction) {
    const double length = std::hypot(direction.x, direction.y, direction.z);
    return {fixed_of<Unit>(direction.x / length), fixed_of<Unit>(direction.y / length),
            fixed_of<Unit>(direction.z / length)};
}

Entry entry_of(double value) {
    return fixed_of<Entry>(value);
}

std::string decimal_text(FigureNumber value, const char* format) {
    char text[64];
    std::snprintf(text, sizeof text, format, value.value);
    return text;
}

std::string decimals_text(std::initializer_list<FigureNumber> values, const char* format, const char* between) {
    std::string text;
    for (const FigureNumber value : values) text += (text.empty() ? "" : between) + decimal_text(value, format);
    return text;
}

std::vector<std::string> matrix_lines(std::string title, const Matrix4& matrix, const char* format,
                                      const char* last_format) {
    std::vector<std::string> lines{std::move(title)};
    for (const auto& row : matrix.rows) lines.push_back(row_text(row, format, last_format));
    return lines;
}

std::vector<Row> gallery_rows() {
    std::map<std::string_view, Row> without_text;
    for (const auto subject : {aspect_rows, clipping_rows, cyclic_overlap_rows, hidden_surface_rows, inspection_rows,
                               line_rows, projection_matrix_rows, projection_rows, shading_rows, stage_rows,
                               texture_rows, transform_rows, triangle_rows, vector_rows, view_rows})
        for (Row& row : subject()) without_text.emplace(row.id, std::move(row));
    std::vector<Row> rows;
    std::string_view text = kRowTexts;
    for (take_paragraph(text); !text.empty();) rows.push_back(with_text(take_paragraph(text), without_text));
    if (!without_text.empty()) throw std::logic_error("no text for " + std::string(without_text.begin()->first));
    return rows;
}

}  // namespace oblong
