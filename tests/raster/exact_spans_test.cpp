#include "engine/raster/exact_spans.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <random>

namespace oblong::test {
namespace {

constexpr std::int32_t kWidth = 320, kHeight = 4, kSize = 256;

/// A surface on which each texel differs from its neighbours.
struct TestSurface {
    std::vector<std::uint8_t> texels = std::vector<std::uint8_t>(kSize * kSize);
    SurfaceView view;

    TestSurface() {
        for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i * 37 + i / kSize * 101);
        view.texels = texels.data();
        view.width = view.height = kSize;
        view.stride_log2 = 8;
        view.u_mask = view.v_mask = kSize - 1;
    }
};

std::vector<std::uint8_t> by_blocks(std::span<const Span> spans, const TextureGradients& gradients,
                                    const TexelLimits& limits, const SurfaceView& surface) {
    Accuracy accuracy;
    accuracy.texturing = Texturing::Exact;
    BlockList blocks(kWidth);
    block_cutter(accuracy)(spans, kWidth, {gradients, limits, {}}, blocks);
    std::vector<std::uint8_t> pixels(kWidth * kHeight);
    draw_blocks_plain(blocks.waiting(), surface, pixels.data());
    return pixels;
}

/// With pieces that are drawn as lines, and without them.
std::vector<std::uint8_t> at_each_pixel(std::span<const Span> spans, const TextureGradients& gradients,
                                        const TexelLimits& limits, const SurfaceView& surface) {
    std::vector<std::uint8_t> pixels(kWidth * kHeight), divided = pixels;
    const auto draw = [&](BlockKernel kernel, std::vector<std::uint8_t>& out) {
        draw_exact_spans(spans, gradients, limits, surface, kernel, {out.data(), kWidth, kHeight, kWidth});
    };
    draw(best_block_kernel(), pixels);
    draw(nullptr, divided);
    EXPECT_EQ(pixels, divided);
    return pixels;
}

template <class Number>
Number nearest(double value) {
    return Number::from_raw(std::llround(std::ldexp(value, Number::kFractionBits)));
}

template <class Value>
LinearQuantity<Value> along(double first, double last) {
    return {nearest<Value>(first), nearest<Value>((last - first) / kWidth), nearest<Value>((last - first) / 9999)};
}

TEST(ExactSpans, DrawTheBytesOfBlocksOfOnePixel) {
    const TestSurface surface;
    std::mt19937 random(11);
    const auto part = [&random](double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(random);
    };
    for (int trial = 0; trial < 3000; ++trial) {
        // Depths of 1:1 to 1:10,000; texels within the surface and beyond its borders, where they are clamped.
        const double w0 = std::exp2(part(-14, 4)), w1 = trial % 5 == 0 ? w0 : std::exp2(part(-14, 4));
        TextureGradients gradients;
        gradients.inverse_z = along<InverseZ>(w0, w1);
        gradients.u_over_z = along<TexelOverZ>(part(-20, 280) * w0, part(-20, 280) * w1);
        gradients.v_over_z = along<TexelOverZ>(part(0, 256) * w0, part(0, 256) * w1);
        const auto first = static_cast<std::int32_t>(random() % 300);
        const Span span{static_cast<std::int32_t>(random() % kHeight), first,
                        first + 1 + static_cast<std::int32_t>(random() % static_cast<unsigned>(kWidth - first))};
        const TexelLimits limits = make_texel_limits(kSize, kSize, kWidth);
        ASSERT_EQ(at_each_pixel({&span, 1}, gradients, limits, surface.view),
                  by_blocks({&span, 1}, gradients, limits, surface.view))
            << trial;
    }
}

/// Walls and floors of level views: one division a column or a row serves all pixels of it.
TEST(ExactSpans, DrawTheBytesOfBlocksWhereZIsConstantAlongColumnsOrRows) {
    const TestSurface surface;
    std::mt19937 random(17);
    const auto part = [&random](double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(random);
    };
    for (int trial = 0; trial < 2000; ++trial) {
        // 1/z is clamped at some columns of some walls, and changes its number of bits at others.
        const double w0 = std::exp2(part(-14, 4)), w1 = trial % 9 == 0 ? -w0 : std::exp2(part(-14, 4));
        TextureGradients gradients;
        gradients.inverse_z = along<InverseZ>(w0, w1);
        gradients.inverse_z.per_row = {};
        if (trial % 3 == 0) gradients.inverse_z = {gradients.inverse_z.origin, {}, gradients.inverse_z.per_column};
        gradients.u_over_z = along<TexelOverZ>(part(-20, 280) * w0, part(-20, 280) * std::abs(w1));
        gradients.v_over_z = along<TexelOverZ>(part(0, 256) * w0, part(0, 256) * std::abs(w1));
        std::vector<Span> spans;
        for (std::int32_t row = 0; row < kHeight; ++row) {
            const auto first = static_cast<std::int32_t>(random() % 300);
            spans.push_back(
                {row, first, first + 1 + static_cast<std::int32_t>(random() % static_cast<unsigned>(kWidth - first))});
        }
        const TexelLimits limits = make_texel_limits(kSize, kSize, kWidth);
        ASSERT_EQ(at_each_pixel(spans, gradients, limits, surface.view),
                  by_blocks(spans, gradients, limits, surface.view))
            << trial;
    }
}

/// Liquids: the bytes of blocks of one pixel, drawn by the plain kernel of what warps.
TEST(ExactSpans, DrawTheBytesOfWarpedBlocksOfOnePixel) {
    const TestSurface surface;
    std::mt19937 random(19);
    const auto part = [&random](double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(random);
    };
    WarpTable warp;
    for (std::uint32_t& shift_16 : warp.shift_16) shift_16 = static_cast<std::uint32_t>(random() % (16 * 65536 + 1));
    const EffectTexels texels{surface.view, &warp, nullptr, nullptr};
    const TexelLimits limits = make_texel_limits(65535, 65535, kWidth);
    Accuracy accuracy;
    accuracy.texturing = Texturing::Exact;
    for (int trial = 0; trial < 1000; ++trial) {
        const double w0 = std::exp2(part(-14, 4)), w1 = trial % 3 == 0 ? w0 : std::exp2(part(-14, 4));
        TextureGradients gradients;
        gradients.inverse_z = along<InverseZ>(w0, w1);
        gradients.u_over_z = along<TexelOverZ>(part(-9, 65540) * w0, part(-9, 65540) * w1);
        gradients.v_over_z = along<TexelOverZ>(part(0, 600) * w0, part(0, 600) * w1);
        const std::array<Span, 2> spans{{{0, static_cast<std::int32_t>(random() % 300), kWidth}, {3, 0, kWidth}}};
        BlockList blocks(kWidth);
        block_cutter(accuracy)(spans, kWidth, {gradients, limits, {}}, blocks);
        std::vector<std::uint8_t> expected(kWidth * kHeight), drawn = expected;
        effect_kernel({true, false, false, true}, false)(blocks.waiting(), texels, expected.data());
        draw_exact_warped_spans(spans, gradients, limits, texels, {drawn.data(), kWidth, kHeight, kWidth});
        ASSERT_EQ(drawn, expected) << trial;
    }
}

/// Depths so alike that pieces are lines, on tiles of up to 65,535 texels: where rounding moves texels most.
TEST(ExactSpans, DrawTheBytesOfBlocksWhereTexelsLieAlmostOnALine) {
    const TestSurface surface;
    std::mt19937 random(13);
    const auto part = [&random](double least, double greatest) {
        return std::uniform_real_distribution<double>(least, greatest)(random);
    };
    for (int trial = 0; trial < 3000; ++trial) {
        const double w0 = std::exp2(part(-14, 4)), w1 = w0 * (1 + part(-1, 1) * std::exp2(part(-12, -1)));
        const double u0 = part(0, 65500), v0 = part(0, 65500), most = std::exp2(part(-4, 9));
        const auto end = [&](double from) { return std::clamp(from + part(-most, most), 0.0, 65500.0); };
        TextureGradients gradients;
        gradients.inverse_z = along<InverseZ>(w0, w1);
        gradients.u_over_z = along<TexelOverZ>(u0 * w0, end(u0) * w1);
        gradients.v_over_z = along<TexelOverZ>(v0 * w0, end(v0) * w1);
        const auto first = static_cast<std::int32_t>(random() % 300);
        const Span span{0, first,
                        first + 1 + static_cast<std::int32_t>(random() % static_cast<unsigned>(kWidth - first))};
        const TexelLimits limits = make_texel_limits(65535, 65535, kWidth);
        ASSERT_EQ(at_each_pixel({&span, 1}, gradients, limits, surface.view),
                  by_blocks({&span, 1}, gradients, limits, surface.view))
            << trial;
    }
}

TEST(ExactSpans, DrawTheBytesOfBlocksWhereZIsBeyondItsRange) {
    const TestSurface surface;
    const TexelLimits limits = make_texel_limits(kSize, kSize, kWidth);
    const Span span{0, 0, kWidth};
    for (const auto& [first, last] :
         {std::pair{-1e-3, 2e-3}, {2e-3, -1e-3}, {0.0, 1e-6}, {40000.0, 20000.0}, {0.0, 0.0}}) {
        TextureGradients gradients;
        gradients.inverse_z = along<InverseZ>(first, last);
        gradients.u_over_z = along<TexelOverZ>(1, 2);
        gradients.v_over_z = along<TexelOverZ>(2, 1);
        EXPECT_EQ(at_each_pixel({&span, 1}, gradients, limits, surface.view),
                  by_blocks({&span, 1}, gradients, limits, surface.view))
            << first << " to " << last;
    }
}

/// Planes that no level has: steps that leave every range within a pixel, sums that wrap.
TEST(ExactSpans, DrawTheBytesOfBlocksForAnyGradients) {
    const TestSurface surface;
    const TexelLimits limits = make_texel_limits(kSize, kSize, kWidth);
    std::mt19937_64 random(12);
    const auto any = [&random] { return static_cast<std::int64_t>(random()) >> random() % 63; };
    for (int trial = 0; trial < 4000; ++trial) {
        TextureGradients gradients;
        // An octave below the greatest 1/z and above it, too.
        const std::int64_t near_greatest = (std::int64_t{1} << 59) + (any() >> 5);
        gradients.inverse_z.origin = InverseZ::from_raw(trial % 2 ? near_greatest : any());
        gradients.inverse_z.per_column = InverseZ::from_raw(any());
        const std::int64_t part = static_cast<std::int64_t>(random() % kSize) * (gradients.inverse_z.origin.raw >> 14);
        gradients.u_over_z = {TexelOverZ::from_raw(trial % 3 ? part : any()), TexelOverZ::from_raw(any()), {}};
        gradients.v_over_z = {TexelOverZ::from_raw(trial % 3 ? part : any()), TexelOverZ::from_raw(any()), {}};
        const Span span{0, 0, 1 + static_cast<std::int32_t>(random() % 20)};
        ASSERT_EQ(at_each_pixel({&span, 1}, gradients, limits, surface.view),
                  by_blocks({&span, 1}, gradients, limits, surface.view))
            << trial;
    }
}

}  // namespace
}  // namespace oblong::test
