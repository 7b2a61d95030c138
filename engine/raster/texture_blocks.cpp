#include "engine/raster/texture_blocks.h"

#include <algorithm>
#include <bit>
#include <cstdlib>
#include <limits>
#include <tuple>

#include "engine/base/range_probe.h"
#include "engine/base/table.h"
#include "engine/fixed/fixed.h"

namespace oblong {

namespace {

/// 1/z, u/z, v/z at one pixel.
struct Perspective {
    InverseZ inverse_z;
    TexelOverZ u_over_z, v_over_z;

    Perspective(const TextureGradients& gradients, std::int32_t column, std::int32_t row)
        : inverse_z(gradients.inverse_z.at(column, row)),
          u_over_z(gradients.u_over_z.at(column, row)),
          v_over_z(gradients.v_over_z.at(column, row)) {
        note_range<"1/z at a block's end">(inverse_z);
        note_range<"u/z, v/z at a block's end">(u_over_z);
        note_range<"u/z, v/z at a block's end">(v_over_z);
    }
};

/// std::clamp by value: the compiler then keeps all of it in registers.
template <class Number>
constexpr Number clamp_value(Number value, Number least, Number greatest) {
    value = value < least ? least : value;
    return value > greatest ? greatest : value;
}

/// 2^92 / normalised, for a number from 2^59 to 2^60. Exact: one 64-bit division, relative error below 2^-26.
template <ReciprocalMethod Method>
std::int64_t reciprocal_of(std::uint64_t normalised) {
    if constexpr (Method == ReciprocalMethod::Exact)
        return static_cast<std::int64_t>((std::uint64_t{1} << 60) / (normalised >> 32));
    else
        return std::int64_t{mantissa_reciprocal(static_cast<std::uint32_t>(normalised >> 28), Method)} * 4;
}

/// z as a reciprocal of 33 bits and a scale.
template <ReciprocalMethod Method>
struct Depth {
    std::int64_t mantissa;       ///< 2^60 / (the leading 28 bits of 1/z), in (2^32, 2^33]
    TexelOverZ greatest_over_z;  ///< u/z beyond which u would be more than 65,535 texels
    int shift;                   ///< what brings 1/z to 60 bits

    explicit Depth(InverseZ inverse_z) {
        const std::int64_t positive = clamp_value(inverse_z, kLeastInverseZ, kGreatestInverseZ).raw;
        shift = std::countl_zero(static_cast<std::uint64_t>(positive)) - 4;
        mantissa = reciprocal_of<Method>(static_cast<std::uint64_t>(positive) << shift);
        greatest_over_z = TexelOverZ::from_raw(positive * 4 - 4);
    }

    /// (u/z) * z, clamped to 0 to 65,535 texels, so that nothing overflows.
    Texel times(TexelOverZ over_z) const {
        using Scaled = Fixed<std::int64_t, 60>;
        const std::int64_t shifted = clamp_value(over_z, {}, greatest_over_z).raw << shift;
        const std::int64_t product = floor_shift(shifted, 32) * mantissa;
        note_range<"u/z, normalised">(Scaled::from_raw(shifted));
        note_range<"u/z x reciprocal">(Scaled::from_raw(product));
        return Texel::from_raw(floor_shift(product, 30));
    }
};

template <ReciprocalMethod Method>
TexelPosition texel_of(const Perspective& at, const Depth<Method>& depth, const TexelLimits& limits) {
    const auto within = [&limits](Texel texel, Texel greatest) {
        return static_cast<std::uint32_t>(clamp_value(texel, limits.least, greatest).raw);
    };
    return {within(depth.times(at.u_over_z), limits.greatest_u), within(depth.times(at.v_over_z), limits.greatest_v)};
}

std::int32_t step_by_shift(std::uint32_t from, std::uint32_t to, int log2) {
    return static_cast<std::int32_t>(floor_shift(std::int64_t{to} - from, log2));
}

std::int32_t step_by_division(std::uint32_t from, std::uint32_t to, std::int32_t steps) {
    const std::int64_t whole = std::int64_t{to} - from;
    return static_cast<std::int32_t>(whole / steps - (whole % steps < 0));
}

/// The step between neighbours, clamped to 32,767 texels, the most that its format holds.
std::int32_t step_to_neighbour(std::uint32_t from, std::uint32_t to) {
    constexpr std::int64_t kSteepest = std::numeric_limits<std::int32_t>::max();
    return static_cast<std::int32_t>(clamp_value(std::int64_t{to} - from, -kSteepest, kSteepest));
}

/// Cuts one span into blocks, left to right. Each block ends where the next begins, so a division serves twice. Its
/// functions are force-inlined, so that its members stay in registers.
template <ReciprocalMethod Method>
class SpanCutter {
  public:
    SpanCutter(const Span& span, std::int32_t pitch, const TextureGradients& gradients, const TexelLimits& limits,
               TexelBlock* out)
        : gradients_(gradients),
          limits_(limits),
          out_(out),
          left_(span.end - span.first),
          pixel_(static_cast<std::uint32_t>(span.y * pitch + span.first)),
          here_(gradients, span.first, span.y),
          depth_(here_.inverse_z),
          texel_(texel_of(here_, depth_, limits)) {}

    std::int32_t left() const { return left_; }
    InverseZ inverse_z() const { return here_.inverse_z; }
    std::int32_t divisions() const { return divisions_; }
    const TexelBlock* end() const { return out_; }

    /// A block of 2^log2 pixels, all of them in the span.
    [[gnu::always_inline]] void cut_power(int log2) {
        const TexelPosition from = texel_;
        advance(std::int32_t{1} << log2);
        append(from, 1 << log2, step_by_shift(from.u_16, texel_.u_16, log2),
               step_by_shift(from.v_16, texel_.v_16, log2));
    }

    /// The last block, of the remaining pixels (1 or more). It ends at the span's last pixel: beyond may lie the end of
    /// the surface, or the horizon of its plane.
    [[gnu::always_inline]] void cut_rest() {
        const std::int32_t steps = left_ - 1;
        if (steps == 0) return append(texel_, 1, 0, 0);
        const TexelPosition from = texel_;
        advance(steps);
        if (steps == 1)
            return append(from, 2, step_to_neighbour(from.u_16, texel_.u_16),
                          step_to_neighbour(from.v_16, texel_.v_16));
        append(from, steps + 1, step_by_division(from.u_16, texel_.u_16, steps),
               step_by_division(from.v_16, texel_.v_16, steps));
    }

    /// A block of 2^log2 pixels, or the last one, if it keeps u and v within `bound_256` of the truth; else nothing. A
    /// block of one or two pixels always does.
    [[gnu::always_inline]] bool try_block(int log2, std::int32_t bound_256) {
        const std::int32_t size = std::int32_t{1} << log2, steps = std::min(size, left_ - 1);
        const auto start = std::tuple(here_, depth_, texel_);
        const TexelPosition from = texel_;
        advance(steps);
        const bool is_within = steps < 2 || is_straight(std::get<Perspective>(start).inverse_z, from, steps, bound_256);
        std::tie(here_, depth_, texel_) = start;
        if (is_within && steps == size) cut_power(log2);
        if (is_within && steps < size) cut_rest();
        return is_within;
    }

  private:
    /// Whether the texels between `from` and here lie within a bound of a straight line. With k the ratio of the two
    /// ends' 1/z, the line is off by |du| (sqrt k - 1) / (sqrt k + 1) <= |du| (k - 1) / 4 at most; a step that is
    /// floored loses less than 2^-16 texel a pixel.
    bool is_straight(InverseZ from_z, TexelPosition from, std::int32_t steps, std::int32_t bound_256) const {
        const InverseZ least = std::min(from_z, here_.inverse_z);
        if (least < kLeastInverseZ) return false;
        const InverseZ rise = absolute(here_.inverse_z - from_z);
        const int shift = std::max(static_cast<int>(std::bit_width(static_cast<std::uint64_t>(least.raw))) - 28, 0);
        const std::int64_t room_16 = std::int64_t{bound_256} * 256 - steps - 4;
        const std::int64_t rise_in_steps = floor_shift(rise, shift).raw + 1;
        if (room_16 < 0 || rise_in_steps >= std::int64_t{1} << 31) return false;
        const std::int64_t texels_16 =
            std::max(std::abs(std::int64_t{texel_.u_16} - from.u_16), std::abs(std::int64_t{texel_.v_16} - from.v_16));
        return texels_16 * rise_in_steps <= 4 * room_16 * floor_shift(least, shift).raw;
    }

    [[gnu::always_inline]] void advance(std::int32_t count) {
        const InverseZ before = here_.inverse_z;
        here_.inverse_z = stepped(before, gradients_.inverse_z.per_column, count);
        here_.u_over_z = stepped(here_.u_over_z, gradients_.u_over_z.per_column, count);
        here_.v_over_z = stepped(here_.v_over_z, gradients_.v_over_z.per_column, count);
        if (here_.inverse_z != before) {
            depth_ = Depth<Method>(here_.inverse_z);
            ++divisions_;
        }
        texel_ = texel_of(here_, depth_, limits_);
    }

    [[gnu::always_inline]] void append(TexelPosition from, std::int32_t count, std::int32_t u_step_16,
                                       std::int32_t v_step_16) {
        *out_++ = {pixel_, count, from.u_16, from.v_16, u_step_16, v_step_16};
        pixel_ += static_cast<std::uint32_t>(count);
        left_ -= count;
    }

    const TextureGradients gradients_;
    const TexelLimits limits_;
    TexelBlock* out_;
    std::int32_t left_;
    std::uint32_t pixel_;
    Perspective here_;
    Depth<Method> depth_;
    TexelPosition texel_;
    std::int32_t divisions_ = 1;
};

template <class Cutter>
[[gnu::always_inline]] inline void cut_every(Cutter& cutter, int log2) {
    while (cutter.left() > 1 << log2) cutter.cut_power(log2);
    cutter.cut_rest();
}

template <class Cutter>
[[gnu::always_inline]] inline void cut_bounded(Cutter& cutter, const BlockThresholds& thresholds) {
    int log2 = kBlockSizes - 1;
    const auto& least = thresholds.least_inverse_z;
    while (true) {
        while (log2 > 0 && cutter.inverse_z() < at(least, log2)) --log2;
        if (cutter.left() <= 1 << log2) return cutter.cut_rest();
        cutter.cut_power(log2);
        while (log2 + 1 < kBlockSizes && cutter.inverse_z() >= least[static_cast<std::size_t>(log2) + 1]) ++log2;
    }
}

/// Tries a block twice as long as the last one, then halves it until it is within the bound.
template <class Cutter>
[[gnu::always_inline]] inline void cut_bounded_texels(Cutter& cutter, std::int32_t bound_256) {
    int log2 = 3;
    while (cutter.left() > 1) {
        while (!cutter.try_block(log2, bound_256)) --log2;
        log2 = std::min(log2 + 1, kBlockSizes - 1);
    }
    if (cutter.left() == 1) cutter.cut_rest();
}

template <Texturing Way, ReciprocalMethod Method>
std::int32_t append_blocks(const Span& span, std::int32_t pitch, const TextureGradients& gradients,
                           const BlockRule& rule, const BlockThresholds& thresholds, const TexelLimits& limits,
                           BlockList& blocks) {
    SpanCutter<Method> cutter(span, pitch, gradients, limits, blocks.end());
    if constexpr (Way == Texturing::Affine) cutter.cut_rest();
    if constexpr (Way == Texturing::Every32) cut_every(cutter, 5);
    if constexpr (Way == Texturing::Every16) cut_every(cutter, 4);
    if constexpr (Way == Texturing::Every8) cut_every(cutter, 3);
    if constexpr (Way == Texturing::Bounded) cut_bounded(cutter, thresholds);
    if constexpr (Way == Texturing::BoundedTexels) cut_bounded_texels(cutter, rule.texel_bound_256);
    if constexpr (Way == Texturing::Exact) cut_every(cutter, 0);
    blocks.set_end(cutter.end());
    return cutter.divisions();
}

template <ReciprocalMethod Method>
BlockCutter cutter_by(Texturing texturing) {
    switch (texturing) {
        case Texturing::Affine:
            return append_blocks<Texturing::Affine, Method>;
        case Texturing::Every32:
            return append_blocks<Texturing::Every32, Method>;
        case Texturing::Every16:
            return append_blocks<Texturing::Every16, Method>;
        case Texturing::Every8:
            return append_blocks<Texturing::Every8, Method>;
        case Texturing::Bounded:
            return append_blocks<Texturing::Bounded, Method>;
        case Texturing::BoundedTexels:
            return append_blocks<Texturing::BoundedTexels, Method>;
        case Texturing::Exact:
            break;
    }
    return append_blocks<Texturing::Exact, Method>;
}

}  // namespace

TexelLimits make_texel_limits(std::int32_t width, std::int32_t height, std::int32_t longest_px) {
    // Flooring a step loses less than a unit of 2^-16 a pixel: from this inset no sample drifts below 0.
    return {Texel::from_raw(longest_px), Texel::from_int(width) - Texel::ulp(), Texel::from_int(height) - Texel::ulp()};
}

TexelPosition texel_at(const TextureGradients& gradients, const TexelLimits& limits, std::int32_t column,
                       std::int32_t row) {
    const Perspective at(gradients, column, row);
    return texel_of(at, Depth<ReciprocalMethod::Exact>(at.inverse_z), limits);
}

BlockCutter block_cutter(const Accuracy& accuracy) {
    switch (accuracy.reciprocal) {
        case ReciprocalMethod::Table256:
            return cutter_by<ReciprocalMethod::Table256>(accuracy.texturing);
        case ReciprocalMethod::Table256Newton:
            return cutter_by<ReciprocalMethod::Table256Newton>(accuracy.texturing);
        case ReciprocalMethod::Table1024Newton:
            return cutter_by<ReciprocalMethod::Table1024Newton>(accuracy.texturing);
        case ReciprocalMethod::Table256TwoNewton:
            return cutter_by<ReciprocalMethod::Table256TwoNewton>(accuracy.texturing);
        case ReciprocalMethod::Exact:
            break;
    }
    return cutter_by<ReciprocalMethod::Exact>(accuracy.texturing);
}

}  // namespace oblong
