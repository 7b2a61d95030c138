#include "engine/mesh/mesh_gradients.h"

#include <algorithm>

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/divide.h"
#include "engine/raster/edges.h"

namespace oblong {

namespace {

struct Side {
    Screen x, y;

    Side(const ScreenPlace& from, const ScreenPlace& to)
        : x(to.screen.x - from.screen.x), y(to.screen.y - from.screen.y) {}
    Screen size() const { return std::max(absolute(x), absolute(y)); }
};

/// part / whole, at most 16; whole > 0. A whole as small as on a screen of 32,768 pixels takes two divisions to 32
/// bits, for 28 bits of the quotient each.
WeightStep step_of(Screen part, ScreenArea whole) {
    constexpr int kBits = 28;
    static_assert(WeightStep::kFractionBits + ScreenArea::kFractionBits - Screen::kFractionBits == 2 * kBits);
    const auto divisor = static_cast<std::uint32_t>(whole.bits());
    if (divisor != whole.bits()) return divide<WeightStep>(part, whole);
    const auto size = static_cast<std::uint32_t>(magnitude(part));
    const ShortDivision high = native::divide_to_32(std::uint64_t{size} << kBits, divisor);
    const ShortDivision low = native::divide_to_32(std::uint64_t{high.remainder} << kBits, divisor);
    // To nearest, ties up.
    const bool is_more = low.remainder + (part >= Screen{}) > divisor - low.remainder;
    const auto quotient = static_cast<std::int64_t>((std::uint64_t{high.quotient} << kBits) + low.quotient + is_more);
    return WeightStep::from_raw(part < Screen{} ? -quotient : quotient);
}

/// 1 / side.
WeightStep step_along(Screen side) {
    return step_of(Screen::from_int(side < Screen{} ? -1 : 1), convert<ScreenArea>(absolute(side)));
}

/// Makes it change along the side from corner `from` to `to` only.
void set_along(const std::array<const ScreenPlace*, 3>& corners, std::uint8_t from, std::uint8_t to,
               Barycentric& weights) {
    const Side side(*corners[from], *corners[to]);
    const bool is_across = absolute(side.x) >= absolute(side.y);
    weights.corners = {corners[from], corners[to], corners[from]};
    weights.order = {from, to, from};
    weights.b_per_column = is_across ? step_along(side.x) : WeightStep{};
    weights.b_per_row = is_across ? WeightStep{} : step_along(side.y);
    weights.c_per_column = weights.c_per_row = WeightStep{};
}

/// The coordinates at a pixel that is covered: edge functions there are from 0 to `area`.
void set_at_pixel(const std::array<const ScreenPlace*, 3>& corners, std::uint32_t area, Barycentric& weights) {
    const auto& [a, b, c] = corners;
    const ScreenVertex centre{Screen::from_int(weights.first_column) + kHalfPixel,
                              Screen::from_int(weights.first_row) + kHalfPixel};
    const auto share = [&](const ScreenPlace& from, const ScreenPlace& to) {
        const ScreenArea part = edge_function(from.screen, to.screen, centre);
        const ShortDivision quotient = native::divide_to_32(part.bits() << PixelWeight::kFractionBits, area);
        return PixelWeight::from_raw(static_cast<std::int32_t>(quotient.quotient));
    };
    weights.b = share(*c, *a);
    weights.c = share(*a, *b);
}

std::int32_t least_column(std::span<const Span> spans) {
    std::int32_t least = spans.front().first;
    for (const Span& span : spans) least = std::min(least, span.first);
    return least;
}

/// The part of a quantity's step that a difference of its values at two corners makes.
template <class Value, class Difference>
inline Value part_of(Difference difference, const StoredStep& step) {
    static_assert(WeightStep::kFractionBits == 48);
    if constexpr (native::kHasShortRegisters && Difference::kFractionBits == Value::kFractionBits)
        if (const auto short_difference = static_cast<std::int32_t>(difference.raw); short_difference == difference.raw)
            return Value::from_raw(native::rounded_product_48(short_difference, step.low, step.high));
    return product<Value>(difference, WeightStep(step));
}

/// A quantity from its values at the corners. Those may have fewer fraction bits: their differences then mostly fit 32
/// bits, whose products are shorter on i386. Its steps have at most 4 bits more than the values; sums at far-away
/// pixels may wrap (LinearQuantity).
template <class Value, class AtCorner>
LinearQuantity<Value> quantity_of(const Barycentric& weights, AtCorner a, AtCorner b, AtCorner c) {
    if (a == b && a == c) return {convert<Value>(a), {}, {}};
    if (weights.has_one_pixel) {
        const auto part = [](AtCorner difference, PixelWeight weight) {
            return wrapping_product<Value>(weight, convert<Value>(difference));
        };
        return {convert<Value>(a) + part(b - a, weights.b) + part(c - a, weights.c), {}, {}};
    }
    LinearQuantity<Value> quantity;
    // In this order compilers ask once whether a difference has 32 bits.
    quantity.per_column = part_of<Value>(b - a, weights.b_per_column);
    quantity.per_row = part_of<Value>(b - a, weights.b_per_row);
    quantity.per_column += part_of<Value>(c - a, weights.c_per_column);
    quantity.per_row += part_of<Value>(c - a, weights.c_per_row);
    const auto moved = [](Value from, Value step, Screen by, std::int32_t pixel) {
        return stepped(from, wrapping_product<Value>(Screen::from_int(pixel) + kHalfPixel - by, step), 1);
    };
    const auto& [x, y] = weights.anchor();
    quantity.origin = moved(moved(convert<Value>(a), quantity.per_column, x, weights.first_column), quantity.per_row, y,
                            weights.first_row);
    return quantity;
}

}  // namespace

bool make_barycentric(const std::array<const ScreenPlace*, 3>& corners, std::span<const Span> spans,
                      Barycentric& weights) {
    constexpr Screen kThinnest = Screen::from_raw(16);
    const auto& [a, b, c] = corners;
    const Side ab(*a, *b), ac(*a, *c), bc(*b, *c);
    const ScreenArea area = widening_product(ab.x, ac.y) - widening_product(ac.x, ab.y);
    if (area <= ScreenArea{}) return false;
    weights.corners = corners;
    weights.order = {0, 1, 2};
    weights.first_row = spans.front().y;
    weights.first_column = least_column(spans);
    const auto short_area = static_cast<std::uint32_t>(area.bits());
    weights.has_one_pixel =
        spans.size() == 1 && spans.front().end - spans.front().first == 1 && short_area == area.bits();
    if (weights.has_one_pixel) {
        set_at_pixel(corners, short_area, weights);
        return true;
    }
    const Screen longest = std::max({ab.size(), ac.size(), bc.size()});
    if (area < widening_product(longest, kThinnest)) {
        const bool is_ab = longest == ab.size();
        set_along(corners, is_ab || longest == ac.size() ? 0 : 1, is_ab ? 1 : 2, weights);
        return true;
    }
    weights.b_per_column = step_of(ac.y, area);
    weights.b_per_row = step_of(-ac.x, area);
    weights.c_per_column = step_of(-ab.y, area);
    weights.c_per_row = step_of(ab.x, area);
    return true;
}

LinearQuantity<InverseZ> inverse_z_over(const Barycentric& weights) {
    const auto& [a, b, c] = weights.corners;
    return quantity_of<InverseZ>(weights, a->inverse_z, b->inverse_z, c->inverse_z);
}

MeshGradients make_mesh_gradients(const Barycentric& weights, const std::array<const CornerValues*, 3>& values,
                                  const LinearQuantity<InverseZ>& inverse_z, const GradientChoice& choice) {
    const auto quantity = [&]<class Value>(Value, auto value_of) {
        const auto at = [&](std::size_t i) { return value_of(*values[weights.order[i]], *weights.corners[i]); };
        return quantity_of<Value>(weights, at(0), at(1), at(2));
    };
    using Corner = const CornerValues&;
    const auto texels = [&](Texel CornerValues::*texel) {
        if (choice.is_affine) return quantity(TexelOverZ{}, [=](Corner corner, const auto&) { return corner.*texel; });
        // Texels are at most kMostTexel, 1/z kGreatestMeshInverseZ.
        return quantity(TexelOverZ{}, [=](Corner corner, const ScreenPlace& place) {
            const auto short_texel = convert<Fixed<std::int32_t, 16>>(corner.*texel);
            return wrapping_product<TexelOverZ>(short_texel, place.inverse_z);
        });
    };
    using Light = Fixed<std::int64_t, 32>;
    using Wide = Fixed<std::int64_t, 30>;
    const auto normal = [&](Unit Vec3<Unit>::*axis) {
        return quantity(Wide{}, [axis](Corner corner, const auto&) { return convert<Wide>(corner.normal.*axis); });
    };
    using Normal = Vec3<LinearQuantity<Wide>>;
    // In place, without copies.
    return {
        weights.first_column,
        weights.first_row,
        {inverse_z, texels(&CornerValues::u), texels(&CornerValues::v)},
        quantity(Light{}, [](Corner corner, const auto&) { return convert<Light>(corner.light); }),
        choice.has_normal ? Normal{normal(&Vec3<Unit>::x), normal(&Vec3<Unit>::y), normal(&Vec3<Unit>::z)} : Normal{}};
}

}  // namespace oblong
