#include <array>
#include <vector>

#include "engine/effects/sky.h"
#include "engine/raster/kernels/effect_kernels.h"
#include "engine/view/views.h"
#include "tools/bench/benchmarks.h"

namespace oblong {
namespace {

constexpr ScreenMode kKernelMode;

/// A texture of 64x64, and a picture cut into blocks of equal length with this texture.
struct KernelInput {
    static constexpr int kSizeLog2 = 6;

    std::vector<std::uint8_t> texels;
    SurfaceView surface;
    std::vector<TexelBlock> blocks;
    std::vector<std::uint8_t> pixels;

    explicit KernelInput(std::int32_t block_px) : pixels(pixel_count(kKernelMode.width_px, kKernelMode.height_px)) {
        constexpr std::uint32_t kSize = 1 << kSizeLog2;
        for (std::uint32_t i = 0; i < kSize * kSize; ++i) texels.push_back(static_cast<std::uint8_t>(i * 37 % 255));
        surface = {texels.data(), kSize, kSize, kSizeLog2, kSize - 1, kSize - 1};
        for (std::uint32_t at = 0; at < pixels.size(); at += static_cast<std::uint32_t>(block_px))
            blocks.push_back({at, block_px, at * 977 % (kSize << 16) + (kSize << 16),
                              at * 613 % (kSize << 16) + (kSize << 16), 48'000, -9'000});
    }
};

void time_block_kernel(benchmark::State& state, BlockKernel kernel) {
    KernelInput input(static_cast<std::int32_t>(state.range(0)));
    for (auto _ : state) {
        kernel(input.blocks, input.surface, input.pixels.data());
        benchmark::ClobberMemory();
    }
    show_time_per("pixel", std::ssize(input.pixels), state);
}

struct NamedTraits {
    const char* name;
    TexelTraits traits;
};

constexpr std::array kEffectTraits{NamedTraits{"warps", {.warps = true}}, NamedTraits{"holes", {.has_holes = true}},
                                   NamedTraits{"blends", {.blends = true}},
                                   NamedTraits{"warps_blends", {.warps = true, .blends = true}}};

/// A table with no special case to optimise for.
BlendTable make_blend_table() {
    BlendTable table;
    for (std::size_t front = 0; front < 256; ++front)
        for (std::size_t behind = 0; behind < 256; ++behind)
            table.rows[front][behind] = static_cast<std::uint8_t>((front + behind) / 2);
    return table;
}

ColourRow make_identity() {
    ColourRow row;
    for (std::size_t i = 0; i < row.size(); ++i) row[i] = static_cast<std::uint8_t>(i);
    return row;
}

void time_effect_kernel(benchmark::State& state, const TexelTraits& traits) {
    KernelInput input(static_cast<std::int32_t>(state.range(0)));
    const WarpTable warp;
    const ColourRow shades = make_identity();
    const BlendTable blend = make_blend_table();
    const EffectTexels texels{input.surface, &warp, &shades, &blend};
    const EffectKernel kernel = effect_kernel(traits, best_kernels());
    for (auto _ : state) {
        kernel(input.blocks, texels, input.pixels.data());
        benchmark::ClobberMemory();
    }
    show_time_per("pixel", std::ssize(input.pixels), state);
}

std::vector<std::uint8_t> make_texels(std::int32_t width, std::int32_t height) {
    std::vector<std::uint8_t> texels(pixel_count(width, height));
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i * 37 % 251);
    return texels;
}

/// Only sky, 20 degrees upward, in spans of equal length.
void time_sky(benchmark::State& state) {
    constexpr ScreenMode kMode;
    constexpr std::int32_t kSize = 128;
    const auto length = static_cast<std::int32_t>(state.range(0));
    const std::vector<std::uint8_t> texels = make_texels(2 * kSize, kSize);
    std::vector<std::uint8_t> pixels(pixel_count(kMode.width_px, kMode.height_px));
    SkyLayers layers;
    std::vector<Span> spans;
    for (std::int32_t y = 0; y < kMode.height_px; ++y)
        for (std::int32_t x = 0; x < kMode.width_px; x += length)
            spans.push_back({y, x, std::min(x + length, kMode.width_px)});
    Camera camera;
    camera.field_of_view = Degrees::from_int(90);
    camera.pitch = degrees_to_angle(Degrees::from_int(-20));
    const ViewContext view = make_view_context(first_person_view(camera), kMode);
    const Framebuffer out{pixels.data(), kMode.width_px, kMode.height_px, kMode.width_px};
    for (auto _ : state) {
        const SkyNow sky = compose_sky({texels.data(), kSize, 2 * kSize}, 0, std::ssize(pixels), layers);
        draw_sky(spans, sky, view.ray_directions(), view.projection, out, best_kernels().draw_blocks);
        benchmark::ClobberMemory();
    }
    show_time_per("pixel", std::ssize(pixels), state);
}

/// A lit surface of 128x128 texels at mip level 0, with one light style or four.
void time_lit_surface(benchmark::State& state) {
    constexpr std::int32_t kSamples = 9, kSize = lit_size(kSamples, 0), kTexture = 64;
    const std::vector<std::uint8_t> texels = make_texels(kTexture, kTexture);
    const std::vector<std::uint8_t> samples = make_texels(kSamples * 4, kSamples);
    const Colormap colormap = make_colormap({});
    LightmapView light{samples.data(), kSamples, kSamples, static_cast<std::int32_t>(state.range(0)), {},
                       nullptr,        false};
    light.style_scale_256.fill(128);
    std::vector<std::int32_t> corner_shades(kSamples * kSamples);
    std::vector<std::uint8_t> out(pixel_count(kSize, kSize));
    for (auto _ : state) {
        build_lit_surface({texels.data(), kTexture, kTexture, 0, 0}, light, {colormap, best_kernels().light_cells}, {},
                          0, kSize, corner_shades.data(), out.data());
        benchmark::ClobberMemory();
    }
    show_time_per("texel", std::ssize(out), state);
}

}  // namespace

void register_kernel_benchmarks() {
    std::vector<std::pair<std::string, BlockKernel>> block_kernels{{"packed", draw_blocks_packed},
                                                                   {"any_size", draw_blocks_any_size}};
    for (const Kernels& kernels : all_kernels()) block_kernels.emplace_back(kernels.name, kernels.draw_blocks);
    for (const auto& [name, draw] : block_kernels)
        benchmark::RegisterBenchmark(("kernel/" + name).c_str(), time_block_kernel, draw)
            ->ArgName("block_px")
            ->Arg(8)
            ->Arg(16)
            ->Arg(32)
            ->Arg(64);
    for (const NamedTraits& named : kEffectTraits)
        benchmark::RegisterBenchmark((std::string("effect_kernel/") + named.name).c_str(), time_effect_kernel,
                                     named.traits)
            ->ArgName("block_px")
            ->Arg(16)
            ->Arg(64);
    benchmark::RegisterBenchmark("sky", time_sky)->ArgName("span_px")->Arg(20)->Arg(320);
    benchmark::RegisterBenchmark("lit_surface", time_lit_surface)->ArgName("styles")->Arg(1)->Arg(4);
}

}  // namespace oblong
