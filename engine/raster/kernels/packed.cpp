#include "engine/raster/kernels/packed.h"

#include <array>

#include "engine/base/table.h"
#include "engine/raster/kernels/effect_kernels.h"

namespace oblong {

void draw_blocks_packed(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const PackedFetch fetch(surface);
    for (const TexelBlock& block : blocks) draw_packed_block(block, pixels, fetch);
}

#if defined(__x86_64__)

namespace {

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

bool has_bmi2() {
    // On AMD's Zen 1 and 2 `pext` is microcoded and slower than shifts and masks.
    return __builtin_cpu_supports("bmi2") && __builtin_cpu_supports("avx") && !__builtin_cpu_is("znver1") &&
           !__builtin_cpu_is("znver2");
}

void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    const Bmi2Fetch fetch(surface);
    for (const TexelBlock& block : blocks) draw_packed_block(block, pixels, fetch);
}

void draw_warped_blocks_bmi2(std::span<const TexelBlock> blocks, const EffectTexels& texels, std::uint8_t* pixels) {
    const UpperShifts upper(*texels.warp);
    const WarpedFetch fetch{texels.warp->shift_16.data(), upper.shift_48.data(), Bmi2Fetch(texels.surface)};
    const EffectKernel draw_one_by_one = effect_kernel(kWarpsAlone, Instructions::Baseline);
    for (const TexelBlock& block : blocks) {
        if (stays_in_half(block))
            draw_packed_block(block, pixels, fetch);
        else
            draw_one_by_one({&block, 1}, texels, pixels);
    }
}

#else

bool has_bmi2() {
    return false;
}

void draw_blocks_bmi2(std::span<const TexelBlock> blocks, const SurfaceView& surface, std::uint8_t* pixels) {
    draw_blocks_packed(blocks, surface, pixels);
}

void draw_warped_blocks_bmi2(std::span<const TexelBlock> blocks, const EffectTexels& texels, std::uint8_t* pixels) {
    effect_kernel(kWarpsAlone, Instructions::Baseline)(blocks, texels, pixels);
}

#endif

}  // namespace oblong
