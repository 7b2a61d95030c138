#include "engine/mesh/mesh_pixels.h"

#include <algorithm>
#include <utility>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"
#include "engine/fixed/divide.h"
#include "engine/fixed/native/native.h"
#include "engine/fixed/root.h"
#include "engine/raster/edges.h"
#include "engine/raster/kernels/effect_kernels.h"

namespace oblong {

namespace {

/// Template parameters of the loop over a span, chosen once a triangle.
struct MeshTraits {
    bool is_phong, is_affine, has_colours, has_holes;
};

/// The interpolated values at one pixel.
struct MeshPixel {
    InverseZ inverse_z;
    TexelOverZ u_over_z, v_over_z;
    Fixed<std::int64_t, 32> light;
    Vec3<Fixed<std::int64_t, 30>> normal;

    template <bool IsPhong>
    static MeshPixel at(const MeshGradients& gradients, auto at) {
        const auto& [inverse_z, u_over_z, v_over_z] = gradients.texture;
        MeshPixel pixel{at(inverse_z), at(u_over_z), at(v_over_z), at(gradients.light), {}};
        if constexpr (IsPhong) pixel.normal = {at(gradients.normal.x), at(gradients.normal.y), at(gradients.normal.z)};
        return pixel;
    }

    template <bool IsPhong>
    void step(const MeshGradients& gradients) {
        const auto next = [](auto& value, const auto& quantity) { value = stepped(value, quantity.per_column, 1); };
        next(inverse_z, gradients.texture.inverse_z);
        next(u_over_z, gradients.texture.u_over_z);
        next(v_over_z, gradients.texture.v_over_z);
        next(light, gradients.light);
        if constexpr (IsPhong) {
            next(normal.x, gradients.normal.x);
            next(normal.y, gradients.normal.y);
            next(normal.z, gradients.normal.z);
        }
    }
};

/// z with 28 fraction bits from 1/z with 32: 1/z of a point of the world is at least 2^-21.
std::int64_t depth_28(InverseZ inverse_z) {
    constexpr std::int64_t kLeast = std::int64_t{1} << 11;
    const auto divisor = static_cast<std::uint64_t>(std::max(floor_of<32>(inverse_z), kLeast));
    return static_cast<std::int64_t>(divide(std::uint64_t{1} << 60, divisor).quotient);
}

/// The texel's number along one axis. As texels are below 2^13 (kMostTexel), u/z times z has at most 62 bits.
std::int32_t texel_number(TexelOverZ over_z, std::int64_t z_28) {
    return static_cast<std::int32_t>(floor_shift(floor_of<21>(over_z) * z_28, 49));
}

/// The texel of these numbers, or the one nearest to them in the skin.
template <class Number>
std::uint8_t nearest_texel(const Skin& skin, Number u, Number v) {
    const auto column = static_cast<std::ptrdiff_t>(std::clamp<Number>(u, 0, skin.width - 1));
    const auto row = static_cast<std::ptrdiff_t>(std::clamp<Number>(v, 0, skin.height - 1));
    return item(skin.texels, row * skin.width + column);
}

template <bool IsAffine>
std::uint8_t texel_at(const MeshPixel& pixel, const Skin& skin) {
    if constexpr (IsAffine) return nearest_texel(skin, floor_of(pixel.u_over_z), floor_of(pixel.v_over_z));
    const std::int64_t z_28 = depth_28(pixel.inverse_z);
    return nearest_texel(skin, texel_number(pixel.u_over_z, z_28), texel_number(pixel.v_over_z, z_28));
}

/// N . to / |N| with 8 fraction bits: interpolated normals are shorter than 1. `over_length` is 1 / |N|.
std::int32_t cosine_8(const Vec3<Fixed<std::int32_t, 14>>& normal, const ReciprocalRoot& over_length,
                      const Vec3<Unit>& to) {
    const auto along = static_cast<std::int32_t>(floor_of<14>(dot(normal, to)));
    if (along <= 0) return 0;
    // The length has 14 fraction bits too.
    const std::uint64_t cosine = native::product_to_64(static_cast<std::uint32_t>(along), over_length.mantissa);
    return static_cast<std::int32_t>(std::min<std::uint64_t>(cosine >> (22 + over_length.shift), 256));
}

/// The shade at a pixel from its interpolated normal.
std::int32_t phong_shade_16(const MeshPixel& pixel, const MeshPaint& paint) {
    const auto part = [](Fixed<std::int64_t, 30> value) { return convert<Fixed<std::int32_t, 14>>(value); };
    const Vec3<Fixed<std::int32_t, 14>> normal{part(pixel.normal.x), part(pixel.normal.y), part(pixel.normal.z)};
    const std::uint64_t square = dot(normal, normal).bits();
    auto light = static_cast<Light8>(floor_of<8>(pixel.light));
    if (square > 0) {
        const ReciprocalRoot over_length = reciprocal_root(square);
        const DirectionalLight& source = paint.light.directional;
        light += cosine_8(normal, over_length, source.toward) * source.strength;
        light += item(*paint.highlight, cosine_8(normal, over_length, paint.halfway));
    }
    return shade_of(brightened(light, paint.light.brightness_100));
}

template <MeshTraits kTraits>
std::int64_t draw_span(const Span& span, const MeshGradients& gradients, const MeshPaint& paint,
                       const MeshTarget& target) {
    InverseDepth* const depths = target.depth.row(span.y);
    std::uint8_t* const pixels = target.out.row(span.y);
    std::int64_t drawn = 0;
    const std::int32_t column = span.first - gradients.first_column, row = span.y - gradients.first_row;
    auto pixel = (column | row) == 0
                     ? MeshPixel::at<kTraits.is_phong>(gradients, [](const auto& quantity) { return quantity.origin; })
                     : MeshPixel::at<kTraits.is_phong>(
                           gradients, [=](const auto& quantity) { return quantity.at_shown(column, row); });
    for (std::int32_t x = span.first; x < span.end; ++x, pixel.template step<kTraits.is_phong>(gradients)) {
        const InverseDepth depth = to_inverse_depth(pixel.inverse_z) | kThingBit;
        if (depths[x] > depth) continue;
        const std::uint8_t texel = texel_at<kTraits.is_affine>(pixel, paint.skin);
        if constexpr (kTraits.has_holes)
            if (texel == kHoleTexel) continue;
        depths[x] = depth;
        std::int64_t shade = floor_of(pixel.light);
        if constexpr (kTraits.is_phong) shade = phong_shade_16(pixel, paint) >> 16;
        const std::uint8_t lit = item(paint.colormap.shades, shade)[texel];
        pixels[x] = kTraits.has_colours ? paint.colours[lit] : lit;
        ++drawn;
    }
    return drawn;
}

/// Triangles whose boxes have at most this many pixel centres across and down are tested centre by centre, if no side
/// is longer than the second number, a power of two.
constexpr std::int32_t kFewCentres = 4;
constexpr Screen kShortSide = Screen::from_int(16);

bool has_short_sides(const std::array<ScreenVertex, 3>& corners) {
    const auto& [a, b, c] = corners;
    const auto moved = [](Screen way) { return (way + kShortSide).bits(); };
    // By the highest bit of all.
    return (moved(b.x - a.x) | moved(b.y - a.y) | moved(c.x - a.x) | moved(c.y - a.y)) < 2 * kShortSide.bits();
}

/// The edge function of a short side, from the right to the left. In steps of 2^-8 it is at most 2 * 16 * 16 * 2^8.
struct ShortEdge {
    std::int32_t at_right, per_column, per_row;

    /// edge_over_pixels() in 32 bits.
    ShortEdge(ScreenVertex from, ScreenVertex to, const ScreenRectangle& box)
        : per_column(from.y.raw - to.y.raw), per_row(to.x.raw - from.x.raw) {
        const std::int32_t right_of = (box.end_column - 1) * 256 + 128 - from.x.raw,
                           below = box.first_row * 256 + 128 - from.y.raw;
        const bool is_left_or_top = per_column > 0 || (per_column == 0 && per_row > 0);
        at_right = floor_shift(per_row * below + per_column * right_of - !is_left_or_top, 8);
    }
};

/// Appends the spans of a clockwise triangle by testing each centre in `box`.
void append_few(const std::array<ScreenVertex, 3>& corners, const ScreenRectangle& box, std::vector<Span>& spans) {
    ShortEdge ab(corners[0], corners[1], box), bc(corners[1], corners[2], box), ca(corners[2], corners[0], box);
    for (std::int32_t y = box.first_row; y < box.end_row; ++y) {
        Span span{y, box.end_column, box.end_column};
        std::int32_t at_ab = ab.at_right, at_bc = bc.at_right, at_ca = ca.at_right;
        for (std::int32_t x = box.end_column - 1; x >= box.first_column; --x) {
            if ((at_ab | at_bc | at_ca) >= 0)
                span.first = x;
            else if (span.first == span.end)
                span.first = span.end = x;
            at_ab -= ab.per_column;
            at_bc -= bc.per_column;
            at_ca -= ca.per_column;
        }
        if (span.first < span.end) spans.push_back(span);
        ab.at_right += ab.per_row;
        bc.at_right += bc.per_row;
        ca.at_right += ca.per_row;
    }
}

using DrawSpan = std::int64_t (*)(const Span&, const MeshGradients&, const MeshPaint&, const MeshTarget&);

template <std::size_t... Index>
constexpr std::array<DrawSpan, sizeof...(Index)> all_loops(std::index_sequence<Index...>) {
    return {draw_span<MeshTraits{(Index & 1) != 0, (Index & 2) != 0, (Index & 4) != 0, (Index & 8) != 0}>...};
}

DrawSpan choose_loop(const MeshTraits& traits) {
    static constexpr auto kLoops = all_loops(std::make_index_sequence<16>());
    return item(kLoops, traits.is_phong + 2 * traits.is_affine + 4 * traits.has_colours + 8 * traits.has_holes);
}

}  // namespace

void append_spans(const ScanlineExtents& rows, const ScreenRectangle& part, std::vector<Span>& spans) {
    for (std::int32_t y = std::max(rows.first, part.first_row); y < std::min(rows.end, part.end_row); ++y) {
        const std::int32_t first = std::max(item(rows.left, y), part.first_column);
        const std::int32_t end = std::min(item(rows.right, y), part.end_column);
        if (first < end) spans.push_back({y, first, end});
    }
}

void find_triangle_spans(const std::array<ScreenVertex, 3>& corners, const ScreenRectangle& part, ScanlineExtents& rows,
                         std::vector<Span>& spans) {
    spans.clear();
    if (edge_function(corners[0], corners[1], corners[2]) <= ScreenArea{}) return;
    const ScreenRectangle box = box_around(corners, part);
    const std::int32_t width = box.end_column - box.first_column, height = box.end_row - box.first_row;
    if (width <= 0 || height <= 0) return;
    if (width <= kFewCentres && height <= kFewCentres && has_short_sides(corners))
        return append_few(corners, box, spans);
    scan_convex(corners, rows);
    append_spans(rows, part, spans);
}

bool is_covered(std::span<const Span> spans, const Barycentric& weights, const LinearQuantity<InverseZ>& inverse_z,
                DepthBuffer& depth) {
    return std::all_of(spans.begin(), spans.end(), [&](const Span& span) {
        const InverseDepth* const depths = depth.row(span.y);
        const std::int32_t column = span.first - weights.first_column, row = span.y - weights.first_row;
        InverseZ at = (column | row) == 0 ? inverse_z.origin : inverse_z.at_shown(column, row);
        for (std::int32_t x = span.first; x < span.end; ++x, at = stepped(at, inverse_z.per_column, 1))
            if (depths[x] <= (to_inverse_depth(at) | kThingBit)) return false;
        return true;
    });
}

std::int64_t draw_mesh_spans(std::span<const Span> spans, const MeshGradients& gradients, const MeshPaint& paint,
                             const MeshTarget& target) {
    const DrawSpan draw =
        choose_loop({paint.shading == Shading::Phong, paint.is_affine, paint.colours != nullptr, paint.skin.has_holes});
    std::int64_t drawn = 0;
    for (const Span& span : spans) drawn += draw(span, gradients, paint, target);
    return drawn;
}

}  // namespace oblong
