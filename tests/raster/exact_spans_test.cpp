#include "engine/raster/exact_spans.h"

#include <gtest/gtest.h>

#include "engine/raster/texture_blocks.h"
#include "tests/support/random.h"

namespace oblong::test::exact_spans_test {
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

/// A face's texels over a row or more.
struct Case {
    TextureGradients gradients;
    std::vector<Span> spans;
    std::int32_t size = kSize;  ///< of what texels are clamped to
};

BlockList blocks_of(const Case& face) {
    Accuracy accuracy;
    accuracy.texturing = Texturing::Exact;
    BlockList blocks(kWidth);
    const TexelLimits limits = make_texel_limits(face.size, face.size, kWidth);
    block_cutter(accuracy)(face.spans, kWidth, {face.gradients, limits, {}}, blocks);
    return blocks;
}

template <class Value>
LinearQuantity<Value> along(double first, double last) {
    return {fixed_of<Value>(first), fixed_of<Value>((last - first) / kWidth), fixed_of<Value>((last - first) / 9999)};
}

Span random_span(std::int32_t row, auto& random) {
    const std::int32_t first = random_below(random, 300);
    return {row, first, first + 1 + random_below(random, kWidth - first)};
}

double depth(std::mt19937_64& random) {
    return std::exp2(random_between(random, -14, 4));
}

/// Depths of 1:1 to 1:10,000; texels within the surface and beyond its borders, where they are clamped.
Case any_slope(std::mt19937_64& random, int trial) {
    const auto part = [&](double least, double greatest) { return random_between(random, least, greatest); };
    const double w0 = depth(random), w1 = trial % 5 == 0 ? w0 : depth(random);
    return {{along<InverseZ>(w0, w1), along<TexelOverZ>(part(-20, 280) * w0, part(-20, 280) * w1),
             along<TexelOverZ>(part(0, 256) * w0, part(0, 256) * w1)},
            {random_span(random_below(random, kHeight), random)}};
}

/// Walls and floors of level views, z constant along columns or rows: one division a column or a row serves all pixels
/// of it; of a wall, where its texture is upright. 1/z is clamped at some columns of some walls, and changes its number
/// of bits at others.
Case wall_or_floor(std::mt19937_64& random, int trial) {
    const auto part = [&](double least, double greatest) { return random_between(random, least, greatest); };
    const double w0 = depth(random), w1 = trial % 9 == 0 ? -w0 : depth(random);
    Case face{{along<InverseZ>(w0, w1), along<TexelOverZ>(part(-20, 280) * w0, part(-20, 280) * std::abs(w1)),
               along<TexelOverZ>(part(0, 256) * w0, part(0, 256) * std::abs(w1))},
              {}};
    LinearQuantity<InverseZ>& inverse_z = face.gradients.inverse_z;
    inverse_z.per_row = {};
    if (trial % 3 == 0) std::swap(inverse_z.per_column, inverse_z.per_row);
    if (trial % 5 != 0) face.gradients.u_over_z.per_row = {};
    for (std::int32_t row = 0; row < kHeight; ++row) face.spans.push_back(random_span(row, random));
    return face;
}

/// Depths so alike that pieces are lines, on tiles of up to 65,535 texels: where rounding moves texels most.
Case almost_a_line(std::mt19937_64& random, int) {
    const auto part = [&](double least, double greatest) { return random_between(random, least, greatest); };
    const double w0 = depth(random), w1 = w0 * (1 + part(-1, 1) * std::exp2(part(-12, -1)));
    const double u0 = part(0, 65500), v0 = part(0, 65500), most = std::exp2(part(-4, 9));
    const auto end = [&](double from) { return std::clamp(from + part(-most, most), 0.0, 65500.0); };
    return {
        {along<InverseZ>(w0, w1), along<TexelOverZ>(u0 * w0, end(u0) * w1), along<TexelOverZ>(v0 * w0, end(v0) * w1)},
        {random_span(0, random)},
        65535};
}

Case beyond_its_range(std::mt19937_64&, int trial) {
    constexpr std::pair<double, double> kRows[] = {{-1e-3, 2e-3}, {2e-3, -1e-3}, {0.0, 1e-6}, {40000.0, 20000.0}, {}};
    const auto& [first, last] = kRows[trial];
    return {{along<InverseZ>(first, last), along<TexelOverZ>(1, 2), along<TexelOverZ>(2, 1)}, {{0, 0, kWidth}}};
}

/// Planes that no level has: steps that leave every range within a pixel, sums that wrap.
Case any_gradients(std::mt19937_64& random, int trial) {
    const auto any = [&random] { return static_cast<std::int64_t>(random()) >> random() % 63; };
    // An octave below the greatest 1/z and above it, too.
    const std::int64_t near_greatest = (std::int64_t{1} << 59) + (any() >> 5),
                       origin = trial % 2 ? near_greatest : any();
    const std::int64_t part = random_below(random, kSize) * (origin >> 14);
    const auto texels = [&] {
        return LinearQuantity<TexelOverZ>{
            TexelOverZ::from_raw(trial % 3 ? part : any()), TexelOverZ::from_raw(any()), {}};
    };
    return {{{InverseZ::from_raw(origin), InverseZ::from_raw(any()), {}}, texels(), texels()},
            {{0, 0, 1 + random_below(random, 20)}}};
}

/// Whether everything fits is known for the whole face, or left to be found for parts of rows.
BlockCutting cutting_of(const Case& face, bool knows_range) {
    BlockCutting cutting;
    cutting.gradients = face.gradients;
    cutting.limits = make_texel_limits(face.size, face.size, kWidth);
    cutting.fits_range = knows_range && fits_range(face.gradients, rectangle_around(face.spans));
    return cutting;
}

/// With pieces that are drawn as lines, and without them: the bytes of blocks of one pixel.
TEST(ExactSpans, DrawTheBytesOfBlocksOfOnePixel) {
    struct Row {
        const char* name;
        int trials;
        Case (*make)(std::mt19937_64&, int);
    };
    const TestSurface surface;
    std::mt19937_64 random(11);
    for (const Row& row : {Row{"any slope", 3000, any_slope},
                           {"walls and floors", 2000, wall_or_floor},
                           {"almost a line", 3000, almost_a_line},
                           {"z beyond its range", 5, beyond_its_range},
                           {"any gradients", 4000, any_gradients}})
        for (int trial = 0; trial < row.trials; ++trial) {
            const Case face = row.make(random, trial);
            std::vector<std::uint8_t> expected(kWidth * kHeight);
            draw_blocks_plain(blocks_of(face).waiting(), surface.view, expected.data());
            for (const Kernels* const kernels :
                 {&all_kernels().back(), &best_kernels(), static_cast<const Kernels*>(nullptr)})
                for (const bool knows_range : {true, false}) {
                    std::vector<std::uint8_t> pixels(kWidth * kHeight);
                    draw_exact_spans(face.spans, cutting_of(face, knows_range), surface.view, kernels,
                                     {pixels.data(), kWidth, kHeight, kWidth});
                    ASSERT_EQ(pixels, expected) << row.name << ", " << trial << (knows_range ? "" : ", by octaves");
                }
        }
}

/// A row of constant depth whose first texels are beyond the surface, by rounding at a face's edge or more.
TEST(ExactSpans, OnlyClampedPixelsAreDividedOneByOne) {
    const TestSurface surface;
    for (const auto& [beyond, clamped] : {std::pair(0.0, 1), std::pair(-10.0, 13)}) {
        const double w = 1.0 / 8;
        Case face{{{fixed_of<InverseZ>(w), {}, {}},
                   along<TexelOverZ>(beyond * w, (beyond + 250) * w),
                   {fixed_of<TexelOverZ>(100 * w), {}, {}}},
                  {{0, 0, kWidth}}};
        std::vector<std::uint8_t> pixels(kWidth * kHeight);
        EXPECT_EQ(draw_exact_spans(face.spans, cutting_of(face, true), surface.view, {},
                                   {pixels.data(), kWidth, kHeight, kWidth}),
                  clamped + 1)
            << beyond;
    }
}

Case any_liquid(std::mt19937_64& random, int trial) {
    const auto part = [&](double least, double greatest) { return random_between(random, least, greatest); };
    const double w0 = depth(random), w1 = trial % 3 == 0 ? w0 : depth(random);
    return {{along<InverseZ>(w0, w1), along<TexelOverZ>(part(-9, 65540) * w0, part(-9, 65540) * w1),
             along<TexelOverZ>(part(0, 600) * w0, part(0, 600) * w1)},
            {{0, random_below(random, 300), kWidth}, {3, 0, kWidth}},
            65535};
}

/// Liquids, upright ones too: the bytes of blocks of one pixel, drawn by the plain kernel of what warps.
TEST(ExactSpans, DrawTheBytesOfWarpedBlocksOfOnePixel) {
    const TestSurface surface;
    std::mt19937_64 random(19);
    WarpTable warp;
    for (std::uint32_t& shift_16 : warp.shift_16) shift_16 = static_cast<std::uint32_t>(random() % (16 * 65536 + 1));
    const EffectTexels texels{surface.view, &warp, nullptr, nullptr};
    for (int trial = 0; trial < 2000; ++trial) {
        const Case face = trial % 2 == 0 ? any_liquid(random, trial / 2) : wall_or_floor(random, trial / 2);
        std::vector<std::uint8_t> expected(kWidth * kHeight);
        plain_effect_kernel(kWarpsAlone)(blocks_of(face).waiting(), texels, expected.data());
        std::vector<std::uint8_t> drawn(kWidth * kHeight);
        draw_exact_warped_spans(face.spans, cutting_of(face, trial % 4 < 2), texels,
                                {drawn.data(), kWidth, kHeight, kWidth});
        ASSERT_EQ(drawn, expected) << trial;
    }
}

}  // namespace
}  // namespace oblong::test::exact_spans_test
