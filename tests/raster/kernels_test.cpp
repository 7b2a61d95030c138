// Every kernel writes the bytes that the definition of one pixel says; those of surfaces that warp, have holes, or show
// what is behind them, too.

#include "engine/raster/kernels/kernels.h"

#include <gtest/gtest.h>

#include <bit>
#include <limits>
#include <utility>
#include <vector>

#include "engine/raster/kernels/effect_kernels.h"
#include "tests/support/random.h"

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace oblong::test::kernels_test {

namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr std::int32_t kLongestBlock = 600;
constexpr std::int64_t kGreatest_16 = (std::int64_t{65535} << 16) + 0xffff;

/// A block whose coordinates stay within [0, 65,535] texels on the way, as the span cutter makes them.
TexelBlock random_block(std::mt19937& random, std::uint32_t pixel) {
    const auto longest = static_cast<std::uint32_t>(random() % 4 ? 64 : kLongestBlock);
    const auto count = static_cast<std::int32_t>(1 + random() % longest);
    const auto coordinate = [&] { return static_cast<std::uint32_t>(random() % 0xffff0000u); };
    const std::uint32_t u = coordinate(), v = coordinate();
    const auto step = [&](std::uint32_t from) {
        const std::int64_t to = coordinate();
        const std::int64_t whole = (to - from) / (random() % 2 ? 1 : 1 << 12);
        return static_cast<std::int32_t>(whole / count);
    };
    return {pixel, count, u, v, step(u), step(v)};
}

/// A block from one limit of its coordinates to the other, or along one of them.
TexelBlock block_at_limits(std::mt19937& random, std::uint32_t pixel, std::int32_t count) {
    const auto from_to = [&]() -> std::pair<std::uint32_t, std::int32_t> {
        const std::int64_t from = random() % 2 ? 0 : kGreatest_16, to = random() % 2 ? 0 : kGreatest_16;
        if (count == 1) return {static_cast<std::uint32_t>(from), static_cast<std::int32_t>(random())};
        const std::int64_t steepest = std::numeric_limits<std::int32_t>::max();
        return {static_cast<std::uint32_t>(from),
                static_cast<std::int32_t>(std::clamp((to - from) / (count - 1), -steepest, steepest))};
    };
    const auto [u, u_step] = from_to();
    const auto [v, v_step] = from_to();
    return {pixel, count, u, v, u_step, v_step};
}

/// Blocks in any order, pixels that belong to none of them between: a kernel that writes beyond a block shows.
struct RandomBlocks {
    std::vector<TexelBlock> blocks;
    std::uint32_t pixel_count = 0;

    explicit RandomBlocks(std::mt19937& random) {
        for (; pixel_count < 5000; pixel_count += static_cast<std::uint32_t>(random() % 3)) {
            blocks.push_back(random_block(random, pixel_count));
            pixel_count += static_cast<std::uint32_t>(blocks.back().count);
        }
        std::shuffle(blocks.begin(), blocks.end(), random);
    }
};

SurfaceView view_of(std::int32_t width, std::int32_t height) {
    SurfaceView view;
    view.width = width;
    view.height = height;
    if (const auto size = static_cast<std::uint32_t>(width); std::has_single_bit(size))
        view.stride_log2 = std::countr_zero(size);
    view.u_mask = static_cast<std::uint32_t>(width) - 1;
    view.v_mask = static_cast<std::uint32_t>(height) - 1;
    return view;
}

/// A third of the texels are holes, where that is an effect.
struct RandomSurface {
    Bytes texels;
    SurfaceView view;

    RandomSurface(std::mt19937& random, std::int32_t width, std::int32_t height)
        : texels(as_size(width * height)), view(view_of(width, height)) {
        for (std::uint8_t& texel : texels) texel = random() % 3 == 0 ? kHoleTexel : random_byte(random);
        view.texels = texels.data();
    }
};

/// The texel at floor(u), floor(v), wrapped by division, in 64-bit arithmetic.
std::uint8_t texel_at(const SurfaceView& surface, std::int64_t u_16, std::int64_t v_16) {
    return surface.texels[v_16 / 65536 % surface.height * surface.width + u_16 / 65536 % surface.width];
}

/// Pixels after all blocks, each by a definition: (u, v, what was behind).
Bytes defined(const std::vector<TexelBlock>& blocks, Bytes pixels, auto pixel_at) {
    for (const TexelBlock& block : blocks)
        for (std::int64_t i = 0; i < block.count; ++i) {
            std::uint8_t& pixel = pixels[block.pixel + static_cast<std::size_t>(i)];
            pixel = pixel_at(block.u_16 + i * block.u_step_16, block.v_16 + i * block.v_step_16, pixel);
        }
    return pixels;
}

Bytes untouched(std::uint32_t pixel_count) {
    return Bytes(pixel_count + 16, 0xa5);  // what lies behind the last block must stay
}

Bytes drawn(BlockKernel kernel, const std::vector<TexelBlock>& blocks, const SurfaceView& surface,
            std::uint32_t pixel_count) {
    Bytes pixels = untouched(pixel_count);
    kernel(blocks, surface, pixels.data());
    return pixels;
}

Bytes defined(const std::vector<TexelBlock>& blocks, const SurfaceView& surface, std::uint32_t pixel_count) {
    return defined(blocks, untouched(pixel_count),
                   [&](std::int64_t u_16, std::int64_t v_16, int) { return texel_at(surface, u_16, v_16); });
}

constexpr std::pair<std::int32_t, std::int32_t> kAnySizes[] = {{300, 7}, {48, 80}, {1, 1}, {513, 3}};

}  // namespace

TEST(Kernels, AllWriteTheDefinition) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const RandomSurface surface(random, 1 << random() % 10, 1 << random() % 10);
        const auto [blocks, pixel_count] = RandomBlocks(random);
        const Bytes expected = defined(blocks, surface.view, pixel_count);
        for (const Kernels& kernels : all_kernels())
            ASSERT_EQ(drawn(kernels.draw_blocks, blocks, surface.view, pixel_count), expected) << kernels.name;
        for (const BlockKernel other : {draw_blocks_packed, draw_blocks_any_size})
            ASSERT_EQ(drawn(other, blocks, surface.view, pixel_count), expected);
    }
}

TEST(Kernels, HardCaseX8_SizesThatAreNoPowersOfTwo) {
    std::mt19937 random(2);
    for (const auto& [width, height] : kAnySizes) {
        const RandomSurface surface(random, width, height);
        const auto [blocks, pixel_count] = RandomBlocks(random);
        EXPECT_EQ(drawn(draw_blocks_any_size, blocks, surface.view, pixel_count),
                  defined(blocks, surface.view, pixel_count));
    }
}

TEST(Kernels, AreFoundByNameFromTheBestToThePlainOnes) {
    EXPECT_EQ(&best_kernels(), &all_kernels().front());
    EXPECT_EQ(all_kernels().back().draw_blocks, draw_blocks_plain);
    for (const Kernels& kernels : all_kernels()) EXPECT_EQ(find_kernels(kernels.name), &kernels);
    ASSERT_TRUE(find_kernels("baseline")) << "on every processor";
    EXPECT_FALSE(find_kernels("avx1024"));
}

TEST(Kernels, BlocksOfEveryLengthAtTheLimitsOfTheirCoordinates) {
    std::mt19937 random(3);
    std::vector<RandomSurface> surfaces;  // up to 65,536 rows, or texels in a row
    for (int width_log2 = 0; width_log2 <= 16; ++width_log2)
        surfaces.emplace_back(random, 1 << width_log2, 1 << (16 - width_log2));
    for (std::int32_t count = 1; count <= kLongestBlock; ++count) {
        const SurfaceView& surface = surfaces[random() % surfaces.size()].view;
        const std::vector<TexelBlock> blocks{block_at_limits(random, 3, count)};
        const auto pixel_count = static_cast<std::uint32_t>(count) + 3;
        const Bytes expected = defined(blocks, surface, pixel_count);
        for (const Kernels& kernels : all_kernels())
            ASSERT_EQ(drawn(kernels.draw_blocks, blocks, surface, pixel_count), expected)
                << kernels.name << ' ' << count;
    }
}

#if __has_include(<sys/mman.h>)

/// Two pages that may be read, between two that may not. What reads a byte beyond them crashes, whatever instruction it
/// does so with: no sanitizer sees what a gather reads.
class GuardedPages {
  public:
    GuardedPages()
        : all_(static_cast<std::uint8_t*>(mmap(nullptr, 4 * kPage, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS, -1, 0))) {
        mprotect(begin(), 2 * kPage, PROT_READ | PROT_WRITE);
    }
    ~GuardedPages() { munmap(all_, 4 * kPage); }
    GuardedPages(const GuardedPages&) = delete;
    GuardedPages& operator=(const GuardedPages&) = delete;

    std::uint8_t* begin() const { return all_ + kPage; }
    std::uint8_t* end() const { return begin() + 2 * kPage; }

    static constexpr std::size_t kPage = 65536;

  private:
    std::uint8_t* all_;
};

TEST(Kernels, ReadNothingBeforeASurfaceNorBehindIt) {
    const GuardedPages pages;
    std::mt19937 random(4);
    for (std::uint8_t* texel = pages.begin(); texel != pages.end(); ++texel) *texel = random_byte(random);
    for (int width_log2 = 0; width_log2 <= 8; ++width_log2)
        for (int height_log2 = 0; height_log2 <= 8; ++height_log2) {
            SurfaceView surface = view_of(1 << width_log2, 1 << height_log2);
            // Of a lit surface, rows may be missing that its mask leaves room for.
            if (height_log2 > 2) surface.height -= 3;
            const auto bytes = static_cast<std::ptrdiff_t>(surface.height) << width_log2;
            for (const std::uint8_t* texels : {pages.begin(), pages.end() - bytes}) {
                surface.texels = texels;
                for (std::int32_t count = 1; count <= 70; ++count) {
                    const auto last = [&](std::int32_t size) { return static_cast<std::uint32_t>(size << 16) - 1; };
                    const auto step = [&](std::int32_t size) { return (size << 16) / count; };
                    const std::vector<TexelBlock> blocks{
                        {0, count, 0, 0, step(surface.width), step(surface.height)},
                        {600, count, last(surface.width), last(surface.height), 0, -step(surface.height)},
                        {1200, count, last(surface.width), last(surface.height), 0, 0}};
                    const auto expected = drawn(draw_blocks_plain, blocks, surface, 1300);
                    for (const Kernels& kernels : all_kernels())
                        ASSERT_EQ(drawn(kernels.draw_blocks, blocks, surface, 1300), expected) << kernels.name;
                }
            }
        }
}

#endif

/// Everything that a kernel of effects may need, at random, and pixels by their definition.
struct RandomEffects {
    RandomSurface surface;
    WarpTable warp;
    ColourRow colours{};
    BlendTable blend;

    RandomEffects(std::mt19937& random, std::int32_t width, std::int32_t height) : surface(random, width, height) {
        for (std::uint32_t& shift_16 : warp.shift_16)
            shift_16 = static_cast<std::uint32_t>(random() % (16 * 65536 + 1));
        fill_at_random(colours, random);
        for (auto& row : blend.rows) fill_at_random(row, random);
    }
    /// Without what the traits do not call for: it must not be read.
    EffectTexels needed_by(TexelTraits traits) const {
        return {surface.view, traits.warps ? &warp : nullptr, traits.blends || traits.has_holes ? &colours : nullptr,
                traits.blends ? &blend : nullptr};
    }
    std::uint8_t pixel_at(TexelTraits traits, std::int64_t u_16, std::int64_t v_16, std::uint8_t below) const {
        const std::int64_t du = traits.warps ? item(warp.shift_16, v_16 / 65536 % 128) : 0,
                           dv = traits.warps ? item(warp.shift_16, u_16 / 65536 % 128) : 0;
        const std::uint8_t texel = texel_at(surface.view, u_16 + du, v_16 + dv);
        if (traits.has_holes && texel == kHoleTexel) return below;
        const std::uint8_t shade = traits.has_holes || traits.blends ? colours[texel] : texel;
        return traits.blends ? blend.rows[shade][below] : shade;
    }
};

void expect_the_definition(std::mt19937& random, const RandomEffects& texels, bool is_wrapped_by_masks) {
    for (int trait = 0; trait < 8; ++trait) {
        const TexelTraits traits{(trait & 1) != 0, (trait & 2) != 0, (trait & 4) != 0, is_wrapped_by_masks};
        const auto [blocks, pixel_count] = RandomBlocks(random);
        Bytes behind(pixel_count + 16);
        fill_at_random(behind, random);
        const Bytes expected =
            defined(blocks, behind, [&](auto... pixel) { return texels.pixel_at(traits, pixel...); });
        for (const Kernels& kernels : all_kernels()) {
            Bytes pixels = behind;
            effect_kernel(traits, kernels)(blocks, texels.needed_by(traits), pixels.data());
            ASSERT_EQ(pixels, expected) << kernels.name << ", traits " << trait << is_wrapped_by_masks;
        }
    }
}

TEST(EffectKernels, SurfacesThatMasksWrap) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 30; ++trial)
        ASSERT_NO_FATAL_FAILURE(
            expect_the_definition(random, RandomEffects(random, 1 << random() % 9, 1 << random() % 9), true));
}

TEST(EffectKernels, SurfacesOfAnySize) {
    std::mt19937 random(2);
    for (const auto& [width, height] : kAnySizes)
        ASSERT_NO_FATAL_FAILURE(expect_the_definition(random, RandomEffects(random, width, height), false));
}

// Which pixels of a line are near the border of a texel, by eight against one by one.
TEST(NearBorders, EightAtATimeFindWhatOneByOneFinds) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 20000; ++trial) {
        const auto any = [&random] { return static_cast<std::uint32_t>(random()); };
        const auto step = [&] { return static_cast<std::int32_t>(any()) >> any() % 31; };
        const TexelBlock block{0, static_cast<std::int32_t>(1 + any() % 64), any(), any(), step(), step()};
        const std::uint32_t error_16 = 1 + any() % 16383;
        for (const Kernels& kernels : all_kernels())
            ASSERT_EQ(kernels.pixels_near_borders(block, error_16), pixels_near_borders_plain(block, error_16))
                << trial;
    }
}

TEST(NearBorders, AreNearByTheErrorAndNoFarther) {
    const auto is_near = [](std::uint32_t u_16) {
        return pixels_near_borders_plain({0, 1, u_16, 0x58000, 0, 0}, 100) != 0;
    };
    EXPECT_FALSE(is_near(0x2ff9b));  // 101 units before
    EXPECT_TRUE(is_near(0x2ff9c));
    EXPECT_TRUE(is_near(0x30000));
    EXPECT_TRUE(is_near(0x30063));
    EXPECT_FALSE(is_near(0x30064));  // 100 behind: an error of 100 leads to the border, which is its own texel's
}

}  // namespace oblong::test::kernels_test
