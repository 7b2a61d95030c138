#include <array>

#include "engine/raster/cut_blocks.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/raster/kernels/packed.h"

namespace oblong {

#if defined(__x86_64__) && defined(__SSE2__)

namespace {

/// Up to eight consecutive pixels, collected in a vector and stored at once, which takes less time. `vpinsrb` is
/// of AVX, which is not enabled for the compiler elsewhere.
struct PixelVector {
    std::uint8_t* out;
    std::uint8_t __attribute__((vector_size(16))) pixels = {};

    template <int kPlace>
    [[gnu::always_inline]] void put(const std::uint8_t& texel) {
        asm("vpinsrb %3, %2, %1, %0" : "=x"(pixels) : "x"(pixels), "m"(texel), "i"(kPlace));
    }
    template <int kCount>
    [[gnu::always_inline]] void finish() const {
        using Words = std::uint64_t __attribute__((vector_size(16)));
        const std::uint64_t word = reinterpret_cast<Words>(pixels)[0];  // `pixels` itself stays in its register
        std::memcpy(out, &word, kCount);
    }
};

/// One `pext`, without enabling BMI2 for the compiler elsewhere.
[[gnu::always_inline]] inline std::uint64_t extracted(std::uint64_t from, std::uint64_t mask) {
    std::uint64_t bits;
    asm("pext %2, %1, %0" : "=r"(bits) : "r"(from), "r"(mask));
    return bits;
}

/// Extracts the texel's offset from the word with `pext`.
struct Bmi2Fetch {
    using Pixels = PixelVector;

    std::uint64_t offset_mask;
    const std::uint8_t* texels;

    explicit Bmi2Fetch(const SurfaceView& surface)
        : offset_mask(std::uint64_t{surface.v_mask} << 48 | std::uint64_t{surface.u_mask} << 16),
          texels(surface.texels) {}

    [[gnu::always_inline]] const std::uint8_t& operator()(std::uint64_t vu) const {
        return texels[extracted(vu, offset_mask)];
    }
};

/// The shifts of v, in the upper half of the word.
struct UpperShifts {
    std::array<std::uint64_t, WarpTable::kEntries> shift_48;

    explicit UpperShifts(const WarpTable& warp) {
        for (std::size_t i = 0; i < WarpTable::kEntries; ++i) shift_48[i] = std::uint64_t{warp.shift_16[i]} << 32;
    }
};

/// Fetches texels of a warping surface; each half of the word of v and u is moved by an addition.
struct WarpedFetch {
    using Pixels = PixelVector;

    const std::uint32_t* u_shifts;
    const std::uint64_t* v_shifts;
    Bmi2Fetch fetch;

    /// Two `pext` a texel are faster than one or three.
    [[gnu::always_inline]] const std::uint8_t& operator()(std::uint64_t vu) const {
        constexpr std::uint64_t kEntryOfU = std::uint64_t{WarpTable::kEntries - 1} << 16;
        return fetch(vu + u_shifts[(vu >> 48) % WarpTable::kEntries] + v_shifts[extracted(vu, kEntryOfU)]);
    }
};

/// Whether the moved u stays in its half of the word over a block. An overflow of v is masked anyway.
bool stays_in_half(const TexelBlock& block) {
    constexpr std::uint32_t kEnd = 0u - (kGreatestShift_texels << 16);
    return block.u_16 < kEnd &&
           block.u_16 + static_cast<std::uint32_t>(block.u_step_16) * static_cast<std::uint32_t>(block.count - 1) <
               kEnd;
}

}  // namespace

void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const Bmi2Fetch fetch(surface);
    for (const TexelBlock& block : blocks) draw_packed_block(block, pixels, fetch);
}

void draw_warped_blocks_bmi2(std::span<const TexelBlock> blocks, const EffectTexels& texels, std::uint8_t* pixels) {
    const UpperShifts upper(*texels.warp);
    const WarpedFetch fetch{texels.warp->shift_16.data(), upper.shift_48.data(), Bmi2Fetch(texels.surface)};
    const EffectKernel draw_one_by_one = plain_effect_kernel(kWarpsAlone);
    for (const TexelBlock& block : blocks) {
        if (stays_in_half(block))
            draw_packed_block(block, pixels, fetch);
        else
            draw_one_by_one({&block, 1}, texels, pixels);
    }
}

/// For processors with BMI2, whose shifts take their count from any register.
[[gnu::target("bmi2,lzcnt"), gnu::flatten]] std::span<const Span> cut_bounded_bmi2(std::span<const Span> spans,
                                                                                   std::int32_t pitch,
                                                                                   const BlockCutting& cutting,
                                                                                   BlockList& blocks) {
    return cut_in_range<Texturing::Bounded>(spans, pitch, cutting, DividedReciprocal{}, blocks);
}

#endif

}  // namespace oblong
