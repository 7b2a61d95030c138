#include <vector>

#include "engine/effects/sky.h"
#include "engine/view/view_spec.h"
#include "engine/view/views.h"
#include "tools/bench/benchmarks.h"

namespace oblong {

namespace {

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
        draw_sky(spans, sky, view.ray_directions(), view.projection, out);
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
        build_lit_surface({texels.data(), kTexture, kTexture, 0, 0}, light, colormap, {}, 0, kSize,
                          corner_shades.data(), out.data());
        benchmark::ClobberMemory();
    }
    show_time_per("texel", std::ssize(out), state);
}

}  // namespace

void register_surface_benchmarks() {
    benchmark::RegisterBenchmark("sky", time_sky)->ArgName("span_px")->Arg(20)->Arg(320);
    benchmark::RegisterBenchmark("lit_surface", time_lit_surface)->ArgName("styles")->Arg(1)->Arg(4);
}

}  // namespace oblong
