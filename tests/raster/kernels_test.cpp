// Every kernel writes the bytes that draw_blocks_plain writes, which are those of the definition.

#include "engine/raster/kernels/kernels.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <utility>
#include <vector>

#include "tests/raster/random_blocks.h"

#if __has_include(<sys/mman.h>)
#include <sys/mman.h>
#endif

namespace oblong::test::kernels_test {

namespace {

SurfaceView view_of(int width_log2, int height_log2) {
    SurfaceView view;
    view.width = 1 << width_log2;
    view.height = 1 << height_log2;
    view.stride_log2 = width_log2;
    view.u_mask = static_cast<std::uint32_t>(view.width) - 1;
    view.v_mask = static_cast<std::uint32_t>(view.height) - 1;
    return view;
}

struct RandomSurface {
    std::vector<std::uint8_t> texels;
    SurfaceView view;

    RandomSurface(std::mt19937& random, int width_log2, int height_log2) : view(view_of(width_log2, height_log2)) {
        texels.resize(std::size_t{1} << (width_log2 + height_log2));
        fill_at_random(texels, random);
        view.texels = texels.data();
    }
};

constexpr std::int64_t kGreatest_16 = (std::int64_t{65535} << 16) + 0xffff;

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

std::vector<std::uint8_t> drawn(BlockKernel kernel, const std::vector<TexelBlock>& blocks, const SurfaceView& surface,
                                std::uint32_t pixel_count) {
    std::vector<std::uint8_t> pixels(pixel_count + 16, 0xa5);  // what lies behind the last block must stay
    kernel(blocks, surface, pixels.data());
    return pixels;
}

/// The definition, in 64-bit arithmetic: the texel at floor(u), floor(v), wrapped by division.
std::vector<std::uint8_t> defined(const std::vector<TexelBlock>& blocks, const SurfaceView& surface,
                                  std::int64_t stride, std::uint32_t pixel_count) {
    std::vector<std::uint8_t> pixels(pixel_count + 16, 0xa5);
    for (const TexelBlock& block : blocks)
        for (std::int64_t i = 0; i < block.count; ++i) {
            const std::int64_t u = (block.u_16 + i * block.u_step_16) / 65536 % surface.width;
            const std::int64_t v = (block.v_16 + i * block.v_step_16) / 65536 % surface.height;
            pixels[block.pixel + static_cast<std::size_t>(i)] = surface.texels[v * stride + u];
        }
    return pixels;
}

}  // namespace

TEST(Kernels, AllWriteTheDefinition) {
    std::mt19937 random(1);
    for (int trial = 0; trial < 200; ++trial) {
        const RandomSurface surface(random, static_cast<int>(random() % 10), static_cast<int>(random() % 10));
        std::uint32_t pixel_count = 0;
        const std::vector<TexelBlock> blocks = random_blocks(random, pixel_count);
        const auto expected = defined(blocks, surface.view, surface.view.width, pixel_count);
        for (const Kernels& kernels : all_kernels())
            ASSERT_EQ(drawn(kernels.draw_blocks, blocks, surface.view, pixel_count), expected) << kernels.name;
        for (const BlockKernel other : {draw_blocks_packed, draw_blocks_any_size})
            ASSERT_EQ(drawn(other, blocks, surface.view, pixel_count), expected);
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
    for (int width_log2 = 0; width_log2 <= 16; ++width_log2) surfaces.emplace_back(random, width_log2, 16 - width_log2);
    for (std::int32_t count = 1; count <= kLongestBlock; ++count) {
        const RandomSurface& surface = surfaces[random() % surfaces.size()];
        const std::vector<TexelBlock> blocks{block_at_limits(random, 3, count)};
        const auto pixel_count = static_cast<std::uint32_t>(count) + 3;
        const auto expected = defined(blocks, surface.view, surface.view.width, pixel_count);
        for (const Kernels& kernels : all_kernels())
            ASSERT_EQ(drawn(kernels.draw_blocks, blocks, surface.view, pixel_count), expected)
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
    for (std::uint8_t* texel = pages.begin(); texel != pages.end(); ++texel)
        *texel = static_cast<std::uint8_t>(random());
    for (int width_log2 = 0; width_log2 <= 8; ++width_log2)
        for (int height_log2 = 0; height_log2 <= 8; ++height_log2) {
            SurfaceView surface = view_of(width_log2, height_log2);
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

TEST(Kernels, HardCaseX8_SizesThatAreNoPowersOfTwo) {
    std::mt19937 random(2);
    for (const auto& [width, height] : {std::pair{300, 7}, {48, 80}, {1, 1}, {513, 3}}) {
        std::vector<std::uint8_t> texels(static_cast<std::size_t>(width * height));
        fill_at_random(texels, random);
        SurfaceView surface;
        surface.texels = texels.data();
        surface.width = width;
        surface.height = height;
        std::uint32_t pixel_count = 0;
        const std::vector<TexelBlock> blocks = random_blocks(random, pixel_count);
        EXPECT_EQ(drawn(draw_blocks_any_size, blocks, surface, pixel_count),
                  defined(blocks, surface, width, pixel_count));
    }
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
