// Seed 3 (course notes): triangles by three methods, the top-left rule, barycentric coordinates.

#include <random>
#include <system_error>
#include <thread>

#include "tools/gallery/filled_triangle.h"

namespace oblong {

namespace {

struct ColouredTriangle {
    ScreenTriangle corners;
    std::uint8_t colour;
};

/// Draws triangles back to front in the rows of a band.
void draw_band(const std::vector<ColouredTriangle>& triangles, TriangleMethod method, const ScreenRectangle& band,
               Framebuffer canvas) {
    TriangleScanner scanner(method, band);
    std::vector<Span> spans;
    for (const ColouredTriangle& triangle : triangles) {
        spans.clear();
        scanner.scan(triangle.corners, spans);
        fill_spans(spans, triangle.colour, canvas);
    }
}

/// Band `index` of a canvas split into `count` bands.
ScreenRectangle band_of(Framebuffer canvas, int index, int count) {
    return {0, canvas.width_px, canvas.height_px * index / count, canvas.height_px * (index + 1) / count};
}

void draw_by_threads(const std::vector<ColouredTriangle>& triangles, TriangleMethod method, int threads,
                     Framebuffer canvas) {
    std::vector<std::thread> running;
    for (int i = 0; i < threads; ++i) {
        try {
            running.emplace_back([&, i] { draw_band(triangles, method, band_of(canvas, i, threads), canvas); });
        } catch (const std::system_error&) {  // there are no threads under DOS
            draw_band(triangles, method, band_of(canvas, i, threads), canvas);
        }
    }
    for (std::thread& thread : running) thread.join();
}

/// Large ones behind, small ones in front, some beyond the canvas, with either order of corners.
std::vector<ColouredTriangle> random_triangles(std::int64_t seed, const RowInput& input, Framebuffer canvas) {
    constexpr int kCount = 60;
    std::mt19937 random(static_cast<std::uint32_t>(seed));
    const auto part = [&] { return static_cast<double>(random() % 65536) / 65536; };
    std::vector<ColouredTriangle> triangles;
    for (int i = 0; i < kCount; ++i) {
        const double size = canvas.width_px * (0.9 - 0.75 * i / kCount);
        const Vec middle{part() * canvas.width_px, part() * canvas.height_px};
        ColouredTriangle triangle{};
        for (ScreenVertex& corner : triangle.corners) {
            const Vec off{(part() - 0.5) * size, (part() - 0.5) * size};
            corner = vertex_at(middle + off);
        }
        const int light = 70 + 120 * i / kCount;
        const std::array<std::array<int, 3>, 4> hues{{{20, 0, -30}, {-30, 0, 30}, {-20, 20, 0}, {40, -20, -30}}};
        const auto& hue = hues[random() % hues.size()];
        triangle.colour = input.colour(light + hue[0], light + hue[1], light + hue[2]);
        triangles.push_back(triangle);
    }
    return triangles;
}

Figures draw_triangle_methods(const RowInput& input, Canvas& canvas) {
    constexpr std::array<int, 3> kThreads{1, 2, 4};
    const auto triangles = random_triangles(input.values[2], input, canvas);
    const auto picture = [&](std::int64_t method, int threads) {
        SidePicture drawn(canvas.width_px, canvas.height_px, input.colour(kGround));
        draw_by_threads(triangles, static_cast<TriangleMethod>(method), threads, drawn);
        return std::move(drawn.indices);
    };
    const int shown_threads = item(kThreads, input.values[1]);
    const auto shown = picture(input.values[0], shown_threads);
    canvas.paint([&](std::int32_t x, std::int32_t y) { return item(shown, y * canvas.width_px + x); });
    for (int i = 1; i < shown_threads; ++i)
        canvas.box({0, band_of(canvas, i, shown_threads).first_row, canvas.width_px, 1}, kWhite);

    std::vector<std::vector<std::uint8_t>> by_one;
    Figures flat_parts, threads;
    for (int method = 0; method < kTriangleMethodCount; ++method) {
        const std::string name(name_of(static_cast<TriangleMethod>(method)));
        by_one.push_back(picture(method, 1));
        if (method > 0)
            flat_parts.push_back(
                {name + ": pixels unlike those of flat parts", 0, count_differences(by_one.back(), by_one.front())});
        threads.push_back({name + " by 2 and 4 threads: pixels unlike by 1", 0,
                           count_differences(picture(method, 2), by_one.back()) +
                               count_differences(picture(method, 4), by_one.back())});
    }
    flat_parts.insert(flat_parts.end(), threads.begin(), threads.end());
    return flat_parts;
}

/// Two triangles with a common side with corners on pixel centres, decided by the rule.
Figures draw_top_left_rule(const RowInput& input, Canvas& canvas) {
    constexpr std::int32_t kColumns = 16, kRows = 9;
    canvas.fill(kNight);
    PixelGrid grid(canvas, {0, kHeader_px, canvas.width_px, canvas.height_px - kHeader_px - kFooter_px}, kColumns,
                   kRows, {36, 42, 58});
    const std::array<Vec, 4> corners{{{1.5, 1.5}, {input.number(0) / 2, 1.5}, {13.5, input.number(1) / 2}, {3.5, 7.5}}};
    SidePicture owners(kColumns, kRows);
    const auto cover = [&](const ScreenTriangle& triangle, Rgb8 colour, std::uint8_t owner) {
        fill_spans(spans_in(triangle, grid.picture), input.colour(colour), grid.picture);
        fill_triangle(triangle, owners, [&](std::int32_t x, std::int32_t y) {
            return static_cast<std::uint8_t>(owners.row(y)[x] + owner);
        });
    };
    cover(triangle_of(corners[0], corners[1], corners[3]), kRust, 1);
    cover(triangle_of(corners[1], corners[2], corners[3]), {56, 120, 184}, 2);
    std::int64_t neither = 0, on_common_side = 0;
    grid.show();
    for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 3}})
        grid.line(item(corners, from), item(corners, to), kCream);
    for (std::int32_t row = 0; row < kRows; ++row)
        for (std::int32_t column = 0; column < kColumns; ++column) {
            const Vec centre{column + 0.5, row + 0.5};
            grid.dot(centre, {12, 12, 20});
            const bool is_on_side = cross(corners[3] - corners[1], centre - corners[1]).z == 0 &&
                                    centre.y > corners[1].y && centre.y < corners[3].y;
            on_common_side += is_on_side;
            neither += is_on_side && owners.row(row)[column] == 0;
        }
    return {{"pixels that both triangles own", 0, std::count(owners.indices.begin(), owners.indices.end(), 3)},
            {"centres on the common side that neither owns", 0, neither},
            {"centres on the common side", on_common_side}};
}

struct NamedPlace {
    const char* name;
    Vec at;
    std::array<double, 3> weights;  ///< by the seed's formula, with signs
};
constexpr std::array<NamedPlace, 4> kPlaces{{{"(1, 1)", {1, 1}, {0.5, 0.25, 0.25}},
                                             {"(5, 5), outside", {5, 5}, {-1.5, 1.25, 1.25}},
                                             {"(2, 2), on a side", {2, 2}, {0, 0.5, 0.5}},
                                             {"(0, 4), a corner", {0, 4}, {0, 0, 1}}}};

constexpr std::array<std::array<int, 4>, 4> kBayer{{{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};

/// Red, green and blue at the corners, each as a linear quantity, dithered to the palette's nearest colours.
void fill_with_gradient(const ScreenTriangle& triangle, const Canvas& canvas) {
    constexpr auto kMost = CornerQuantity::from_int(255);
    const std::array<LinearQuantity<CornerQuantity>, 3> channels{
        quantity_over(triangle, {kMost, {}, {}}), quantity_over(triangle, {CornerQuantity{}, kMost, {}}),
        quantity_over(triangle, {CornerQuantity{}, {}, kMost})};
    fill_triangle(triangle, canvas, [&](std::int32_t x, std::int32_t y) {
        const int dither = item(item(kBayer, y & 3), x & 3) * 4 - 30;
        const auto channel = [&](int i) {
            return std::clamp(static_cast<int>(floor_of(item(channels, i).at(x, y))) + dither, 0, 255);
        };
        return canvas.input.colour(channel(0), channel(1), channel(2));
    });
}

constexpr std::array<Vec, 3> kTriangle{{{0, 0}, {4, 0}, {0, 4}}};

/// cross2d of each side and P, in a triangle with P = (1, 1) inside, y down; corners in either order.
std::string draw_winding(bool is_clockwise, const Vec& at, Diagram& diagram) {
    std::array<Vec, 3> corners = kTriangle;
    if (!is_clockwise) std::swap(corners[1], corners[2]);
    const BarycentricWeights w =
        barycentric_weights(triangle_of(corners[0], corners[1], corners[2]), vertex_at({1, 1}));
    const std::string text = decimals_text({w.c, w.a, w.b}, "%.0f");
    const auto place = [&](const Vec& p) { return Vec{at.x + p.x * 0.24, at.y - p.y * 0.24}; };
    const Rgb8 colour = is_clockwise ? kGreen : Rgb8{220, 120, 90};
    for (std::size_t i = 0; i < 3; ++i) {
        const Vec from = place(corners[i]), to = place(corners[(i + 1) % 3]);
        diagram.line(from, to, colour);
        diagram.arrow(from, from * 0.4 + to * 0.6, colour);
    }
    diagram.disc(place({1, 1}), 0.06, colour);
    diagram.label({at.x + 0.98, at.y}, is_clockwise ? "clockwise" : "reversed", colour, 3, -2);
    diagram.label({at.x + 0.98, at.y}, text, colour, 3, 8);
    return text;
}

Figures draw_barycentric(const RowInput& input, Canvas& canvas) {
    const NamedPlace& place = item(kPlaces, input.values[0]);
    Diagram diagram(canvas, {2.5, 2.5}, 6.4);
    diagram.fill(kNight);
    const auto& [a, b, c] = kTriangle;
    fill_with_gradient(triangle_of(diagram.pixel_of(a), diagram.pixel_of(b), diagram.pixel_of(c)), canvas);
    for (std::size_t i = 0; i < 3; ++i) {
        diagram.line(kTriangle[i], kTriangle[(i + 1) % 3], kPale);
        diagram.line(kTriangle[i], place.at, kBright);
    }
    diagram.label(a, "A (0, 0)", kPale, -54);
    diagram.label(b, "B (4, 0)", kPale);
    diagram.label(c, "C (0, 4)", kPale, -54);
    diagram.disc(place.at, 0.08, kBright);

    const BarycentricWeights w = barycentric_weights(triangle_of(a, b, c), vertex_at(place.at));
    const std::array parts{w.a, w.b, w.c};
    constexpr std::array<std::array<const char*, 2>, 3> kNames{
        {{"alpha", " = PBC / ABC"}, {"beta", " = PCA / ABC"}, {"gamma", " = PAB / ABC"}}};
    Figures figures;
    double sum = 0;
    for (std::size_t i = 0; i < 3; ++i) {
        const double found = number_of(parts[i]) / number_of(w.whole);
        sum += found;
        figures.push_back({std::string(kNames[i][0]) + kNames[i][1], place.weights[i], found, 1e-12, 2});
        diagram.label({4.9, 2.6 - 0.5 * static_cast<double>(i)}, kNames[i][0] + (" = " + figures.back().found),
                      kBright);
    }
    diagram.label({-2.9, 5.65}, "cross2d, y down:", kPale, 3, 1);
    figures.push_back(
        {"cross2d of each side and P, clockwise, y down", "4 8 4", draw_winding(true, {-2.75, 5.1}, diagram)});
    figures.push_back({"the same counter-clockwise", "-4 -8 -4", draw_winding(false, {-2.75, 3.2}, diagram)});
    figures.push_back({"their sum", 1, sum, 1e-12, 2});
    return figures;
}

}  // namespace

std::vector<Row> triangle_rows() {
    std::vector<std::string> methods;
    for (int i = 0; i < kTriangleMethodCount; ++i) methods.push_back(name_of(static_cast<TriangleMethod>(i)));
    return {{"triangles",
             draw_triangle_methods,
             {{"method", methods, 2}, {"threads", {"1", "2", "4"}, 2}, {"seed", 1, 99, 1, 7}}},
            {"top-left-rule",
             draw_top_left_rule,
             {{"top corner, half columns", 13, 27, 1, 23}, {"right corner, half rows", 4, 16, 1, 11}}},
            {"barycentric", draw_barycentric, {choice_of("P", kPlaces)}}};
}

}  // namespace oblong
