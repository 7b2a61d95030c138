// Seed 3 (course notes): triangles by three methods, the top-left rule, barycentric coordinates.

#include <array>
#include <cmath>
#include <random>
#include <system_error>
#include <thread>

#include "engine/base/table.h"
#include "engine/methods/triangles.h"
#include "tools/gallery/diagram.h"
#include "tools/gallery/row.h"

namespace oblong {

namespace {

ScreenVertex vertex_at(PlanePoint at) {
    return {fixed_of<Screen>(at.x), fixed_of<Screen>(at.y)};
}

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
        const PlanePoint middle{part() * canvas.width_px, part() * canvas.height_px};
        ColouredTriangle triangle{};
        for (ScreenVertex& corner : triangle.corners)
            corner = vertex_at({middle.x + (part() - 0.5) * size, middle.y + (part() - 0.5) * size});
        const int light = 70 + 120 * i / kCount;
        const std::array<std::array<int, 3>, 4> hues{{{20, 0, -30}, {-30, 0, 30}, {-20, 20, 0}, {40, -20, -30}}};
        const auto& hue = hues[random() % hues.size()];
        triangle.colour = input.assets.colour(light + hue[0], light + hue[1], light + hue[2]);
        triangles.push_back(triangle);
    }
    return triangles;
}

Figures draw_triangle_methods(const RowInput& input, Framebuffer canvas) {
    constexpr std::array<int, 3> kThreads{1, 2, 4};
    const std::uint8_t ground = input.assets.colour(20, 24, 36);
    const auto triangles = random_triangles(input.values[2], input, canvas);
    const auto picture = [&](int method, int threads) {
        std::vector<std::uint8_t> pixels(pixel_count(canvas.width_px, canvas.height_px), ground);
        draw_by_threads(triangles, static_cast<TriangleMethod>(method), threads,
                        {pixels.data(), canvas.width_px, canvas.height_px, canvas.width_px});
        return pixels;
    };
    const int shown_threads = item(kThreads, input.values[1]);
    const auto shown = picture(static_cast<int>(input.values[0]), shown_threads);
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        std::copy_n(shown.data() + std::int64_t{y} * canvas.width_px, canvas.width_px, canvas.row(y));
    for (int i = 1; i < shown_threads; ++i)
        fill_area(canvas, {0, band_of(canvas, i, shown_threads).first_row, canvas.width_px, 1},
                  input.assets.colour(240, 240, 240));

    Figures figures;
    for (int method = 1; method < kTriangleMethodCount; ++method)
        figures.push_back(count_figure(
            std::string(name_of(static_cast<TriangleMethod>(method))) + ": pixels unlike those of flat parts", 0,
            count_differences(picture(method, 1), picture(0, 1))));
    for (int method = 0; method < kTriangleMethodCount; ++method)
        figures.push_back(count_figure(
            std::string(name_of(static_cast<TriangleMethod>(method))) + " by 2 and 4 threads: pixels unlike by 1", 0,
            count_differences(picture(method, 2), picture(method, 1)) +
                count_differences(picture(method, 4), picture(method, 1))));
    return figures;
}

/// Two triangles with a common side with corners on pixel centres, decided by the rule.
Figures draw_top_left_rule(const RowInput& input, Framebuffer canvas) {
    constexpr std::int32_t kColumns = 16, kRows = 9;
    fill(canvas, input.colour(16, 18, 28));
    const std::uint8_t ground = input.colour(36, 42, 58);
    PixelGrid grid(input, canvas, {0, kHeader_px, canvas.width_px, canvas.height_px - kHeader_px - kFooter_px},
                   kColumns, kRows, ground);
    const double x = input.number(0) / 2, y = input.number(1) / 2;
    const std::array<PlanePoint, 4> corners{{{1.5, 1.5}, {x, 1.5}, {13.5, y}, {3.5, 7.5}}};
    const ScreenTriangle first{vertex_at(corners[0]), vertex_at(corners[1]), vertex_at(corners[3])},
        second{vertex_at(corners[1]), vertex_at(corners[2]), vertex_at(corners[3])};

    TriangleScanner scanner(TriangleMethod::EdgeFunctions, {0, kColumns, 0, kRows});
    const auto cover = [&](const ScreenTriangle& triangle, std::uint8_t colour) {
        std::vector<Span> spans;
        scanner.scan(triangle, spans);
        std::vector<std::uint8_t> covered(pixel_count(kColumns, kRows), 0);
        fill_spans(spans, 1, {covered.data(), kColumns, kRows, kColumns});
        fill_spans(spans, colour, grid.picture());
        return covered;
    };
    const auto by_first = cover(first, input.colour(200, 120, 48)),
               by_second = cover(second, input.colour(56, 120, 184));
    std::int64_t twice = 0, neither = 0, on_common_side = 0;
    for (std::int32_t row = 0; row < kRows; ++row)
        for (std::int32_t column = 0; column < kColumns; ++column) {
            const auto pixel = as_size(row * kColumns + column);
            const double across = corners[3].x - corners[1].x, down = corners[3].y - corners[1].y;
            const double beside = across * (row + 0.5 - corners[1].y) - down * (column + 0.5 - corners[1].x);
            const bool is_on_side = beside == 0 && row + 0.5 > corners[1].y && row + 0.5 < corners[3].y;
            twice += by_first[pixel] != 0 && by_second[pixel] != 0;
            on_common_side += is_on_side;
            neither += is_on_side && by_first[pixel] == 0 && by_second[pixel] == 0;
        }
    grid.show(input.colour(16, 18, 28));
    const std::uint8_t line = input.colour(240, 236, 220);
    for (const auto& [from, to] : {std::pair{0, 1}, {1, 2}, {2, 3}, {3, 0}, {1, 3}})
        grid.line(item(corners, from), item(corners, to), line);
    for (std::int32_t row = 0; row < kRows; ++row)
        for (std::int32_t column = 0; column < kColumns; ++column)
            grid.dot({column + 0.5, row + 0.5}, input.colour(12, 12, 20));
    return {count_figure("pixels that both triangles own", 0, twice),
            count_figure("centres on the common side that neither owns", 0, neither),
            measured("centres on the common side", on_common_side)};
}

struct NamedPlace {
    const char* name;
    PlanePoint at;
    std::array<double, 3> weights;  ///< by the seed's formula, with signs
};
constexpr std::array<NamedPlace, 4> kPlaces{{{"(1, 1)", {1, 1}, {0.5, 0.25, 0.25}},
                                             {"(5, 5), outside", {5, 5}, {-1.5, 1.25, 1.25}},
                                             {"(2, 2), on a side", {2, 2}, {0, 0.5, 0.5}},
                                             {"(0, 4), a corner", {0, 4}, {0, 0, 1}}}};

double share_of(ScreenArea part, ScreenArea whole) {
    return number_of(part) / number_of(whole);
}

constexpr std::array<std::array<int, 4>, 4> kBayer{{{0, 8, 2, 10}, {12, 4, 14, 6}, {3, 11, 1, 9}, {15, 7, 13, 5}}};

/// Red, green and blue at the corners, each as a linear quantity, dithered to the palette's nearest colours.
void fill_with_gradient(const ScreenTriangle& triangle, const RowInput& input, Framebuffer canvas) {
    constexpr auto kMost = CornerQuantity::from_int(255);
    const std::array<LinearQuantity<CornerQuantity>, 3> channels{
        quantity_over(triangle, {kMost, {}, {}}), quantity_over(triangle, {CornerQuantity{}, kMost, {}}),
        quantity_over(triangle, {CornerQuantity{}, {}, kMost})};
    TriangleScanner scanner(TriangleMethod::EdgeFunctions, {0, canvas.width_px, 0, canvas.height_px});
    std::vector<Span> spans;
    scanner.scan(triangle, spans);
    for (const Span& span : spans)
        for (std::int32_t x = span.first; x < span.end; ++x) {
            const int dither = item(item(kBayer, span.y & 3), x & 3) * 4 - 30;
            const auto channel = [&](int i) {
                return std::clamp(static_cast<int>(floor_of(item(channels, i).at(x, span.y))) + dither, 0, 255);
            };
            canvas.row(span.y)[x] = input.assets.colour(channel(0), channel(1), channel(2));
        }
}

/// cross2d of each side and P, in a triangle with P = (1, 1) inside, y down; corners in either order.
std::string draw_winding(bool is_clockwise, PlanePoint at, const RowInput& input, Diagram& diagram) {
    std::array<PlanePoint, 3> corners{{{0, 0}, {4, 0}, {0, 4}}};
    if (!is_clockwise) std::swap(corners[1], corners[2]);
    ScreenTriangle triangle;
    for (std::size_t i = 0; i < 3; ++i) triangle[i] = vertex_at(corners[i]);
    const BarycentricWeights w = barycentric_weights(triangle, vertex_at({1, 1}));
    const std::string text = decimals_text({number_of(w.c), number_of(w.a), number_of(w.b)}, "%.0f");
    const auto place = [&](PlanePoint p) { return PlanePoint{at.x + p.x * 0.24, at.y - p.y * 0.24}; };
    const std::uint8_t colour = is_clockwise ? input.colour(110, 220, 120) : input.colour(220, 120, 90);
    for (std::size_t i = 0; i < 3; ++i) {
        const PlanePoint from = place(corners[i]), to = place(corners[(i + 1) % 3]);
        diagram.line(from, to, colour);
        diagram.arrow(from, from * 0.4 + to * 0.6, colour);
    }
    diagram.disc(place({1, 1}), 0.06, colour);
    diagram.text({at.x + 0.98, at.y}, is_clockwise ? "clockwise" : "reversed", colour, 3, -2);
    diagram.text({at.x + 0.98, at.y}, text, colour, 3, 8);
    return text;
}

Figures draw_barycentric(const RowInput& input, Framebuffer canvas) {
    const NamedPlace& place = item(kPlaces, input.values[0]);
    Diagram diagram(input, canvas, {2.5, 2.5}, 6.4);
    diagram.fill(input.colour(16, 18, 28));
    const std::array<PlanePoint, 3> corners{{{0, 0}, {4, 0}, {0, 4}}};
    ScreenTriangle on_canvas, in_plane;
    for (int i = 0; i < 3; ++i) {
        item(on_canvas, i) = vertex_at(diagram.on_canvas(item(corners, i)));
        item(in_plane, i) = vertex_at(item(corners, i));
    }
    fill_with_gradient(on_canvas, input, canvas);
    const std::uint8_t white = input.colour(250, 250, 250), grey = input.colour(150, 160, 180);
    for (int i = 0; i < 3; ++i) {
        diagram.line(item(corners, i), item(corners, (i + 1) % 3), grey);
        diagram.line(item(corners, i), place.at, white);
    }
    diagram.text(corners[0], "A (0, 0)", grey, -54);
    diagram.text(corners[1], "B (4, 0)", grey);
    diagram.text(corners[2], "C (0, 4)", grey, -54);
    diagram.disc(place.at, 0.08, white);

    const BarycentricWeights w = barycentric_weights(in_plane, vertex_at(place.at));
    const std::array<double, 3> found{share_of(w.a, w.whole), share_of(w.b, w.whole), share_of(w.c, w.whole)};
    Figures figures;
    const std::array<const char*, 3> names{"alpha = PBC / ABC", "beta = PCA / ABC", "gamma = PAB / ABC"};
    for (int i = 0; i < 3; ++i) {
        figures.push_back(number_figure(item(names, i), item(place.weights, i), item(found, i), 1e-12, 2));
        diagram.text({4.9, 2.6 - 0.5 * i},
                     std::string(item(names, i)).substr(0, std::string_view(item(names, i)).find(' ')) + " = " +
                         figures.back().found,
                     white);
    }
    diagram.text({-2.9, 5.65}, "cross2d, y down:", grey, 3, 1);
    const std::string clockwise = draw_winding(true, {-2.75, 5.1}, input, diagram),
                      reversed = draw_winding(false, {-2.75, 3.2}, input, diagram);
    figures.push_back({"cross2d of each side and P, clockwise, y down", "4 8 4", clockwise, clockwise == "4 8 4"});
    figures.push_back({"the same counter-clockwise", "-4 -8 -4", reversed, reversed == "-4 -8 -4"});
    figures.push_back(number_figure("their sum", 1, found[0] + found[1] + found[2], 1e-12, 2));
    return figures;
}

/// A floor tile as two triangles: near side at depth 1, far side at depth `far`.
struct Tile {
    std::array<PlanePoint, 4> corners;  ///< on the canvas: near left, near right, far right, far left
    double far_depth;
};
constexpr std::array<PlanePoint, 4> kTexels{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}};

/// Both coordinates at a pixel: interpolated directly, or as u/z, v/z and divided by 1/z.
class TileTexture {
  public:
    TileTexture(const Tile& tile, const std::array<int, 3>& corners, bool is_perspective) {
        std::array<CornerQuantity, 3> u, v, inverse_z;
        for (int i = 0; i < 3; ++i) {
            const int corner = item(corners, i);
            item(triangle, i) = vertex_at(item(tile.corners, corner));
            const double over = is_perspective && corner >= 2 ? 1 / tile.far_depth : 1;
            item(u, i) = fixed_of<CornerQuantity>(item(kTexels, corner).x * over);
            item(v, i) = fixed_of<CornerQuantity>(item(kTexels, corner).y * over);
            item(inverse_z, i) = fixed_of<CornerQuantity>(over);
        }
        u_ = quantity_over(triangle, u);
        v_ = quantity_over(triangle, v);
        inverse_z_ = quantity_over(triangle, inverse_z);
    }
    PlanePoint at_pixel(std::int32_t x, std::int32_t y) const {
        const auto over_z = [&](const auto& linear) { return number_of(linear.at(x, y)); };
        return {over_z(u_) / over_z(inverse_z_), over_z(v_) / over_z(inverse_z_)};
    }

    ScreenTriangle triangle;

  private:
    LinearQuantity<CornerQuantity> u_, v_, inverse_z_;
};

constexpr std::array<std::array<int, 3>, 2> kHalves{{{0, 3, 2}, {0, 2, 1}}};

void draw_tile(const Tile& tile, bool is_perspective, const RowInput& input, Framebuffer canvas) {
    const std::array<std::uint8_t, 2> colours{input.assets.colour(196, 176, 136), input.assets.colour(72, 56, 48)};
    for (const auto& half : kHalves) {
        const TileTexture texture(tile, half, is_perspective);
        TriangleScanner scanner(TriangleMethod::EdgeFunctions, {0, canvas.width_px, 0, canvas.height_px});
        std::vector<Span> spans;
        scanner.scan(texture.triangle, spans);
        for (const Span& span : spans)
            for (std::int32_t x = span.first; x < span.end; ++x) {
                const PlanePoint texel = texture.at_pixel(x, span.y);
                const int square =
                    static_cast<int>(std::floor(texel.x * 8)) + static_cast<int>(std::floor(texel.y * 8));
                canvas.row(span.y)[x] = item(colours, square & 1);
            }
    }
}

/// The texel half way up the left side of the screen, between depth 1 and `far`: v is 0 to 1 along it.
double middle_of_side(double far_depth, bool is_perspective) {
    const Tile tile{{{{0.5, 64.5}, {40.5, 64.5}, {30.5, 0.5}, {0.5, 0.5}}}, far_depth};
    return TileTexture(tile, kHalves[0], is_perspective).at_pixel(0, 32).y;
}

Figures draw_perspective(const RowInput& input, Framebuffer canvas) {
    const auto far_depth = input.number(0);
    fill(canvas, input.assets.colour(16, 18, 28));
    const double half = canvas.width_px / 2.0, near_y = canvas.height_px - kFooter_px - 4, horizon = kHeader_px + 6,
                 far_y = horizon + (near_y - horizon) / far_depth;
    for (const bool is_perspective : {false, true}) {
        const double middle = half * (is_perspective ? 1.5 : 0.5), across = half * 0.47;
        const Tile tile{{{{middle - across, near_y},
                          {middle + across, near_y},
                          {middle + across / far_depth, far_y},
                          {middle - across / far_depth, far_y}}},
                        far_depth};
        draw_tile(tile, is_perspective, input, canvas);
        draw_text(canvas, static_cast<std::int32_t>(middle - half / 2) + kTextMargin_px, kHeader_px + 2,
                  is_perspective ? "u/z, v/z, 1/z" : "u, v", input.assets.text);
    }
    return {number_figure("u half way along an edge, by u/z and 1/z", 1 / (1 + far_depth),
                          middle_of_side(far_depth, true), 1e-6),
            number_figure("u half way along an edge, by u itself", 0.5, middle_of_side(far_depth, false), 1e-6)};
}

}  // namespace

std::vector<Row> triangle_rows() {
    std::vector<std::string> methods;
    for (int i = 0; i < kTriangleMethodCount; ++i) methods.push_back(name_of(static_cast<TriangleMethod>(i)));
    return {{"triangles",
             draw_triangle_methods,
             {choice_parameter("method", methods, 2),
              choice_parameter("threads", {"1", "2", "4"}, 2),
              {"seed", 1, 99, 1, 7}}},
            {"top-left-rule",
             draw_top_left_rule,
             {{"top corner, half columns", 13, 27, 1, 23}, {"right corner, half rows", 4, 16, 1, 11}}},
            {"barycentric", draw_barycentric, {choice_of("P", kPlaces)}},
            {"perspective-correct", draw_perspective, {{"far depth", 2, 9, 1, 3}}}};
}

}  // namespace oblong
