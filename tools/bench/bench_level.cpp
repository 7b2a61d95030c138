#include "tools/bench/bench_level.h"

#include "engine/files/files.h"
#include "engine/level/bsp_read.h"
#include "tools/accuracy/measured_level.h"
#include "tools/render/camera_list.h"

namespace oblong {

BenchLevel read_bench_level(const std::string& level, const std::string& cameras, const std::string& palette) {
    BenchLevel read{
        level.substr(level.find_last_of('/') + 1),
        read_parsed(level, read_bsp),
        make_colormap(read_parsed(palette, read_palette)),
        {},
        read_parsed(cameras, [](const auto& bytes) { return parse_cameras(bytes, Degrees::from_int(90)); })};
    read.models = models_at_rest(read.level);
    return read;
}

BenchLevel make_bench_level(const std::string& palette) {
    constexpr std::size_t kMostCameras = 8;
    const Palette colours = read_parsed(palette, read_palette);
    MeasuredLevel sphere = std::move(make_hard_scenes(colours, kMostCameras).back());
    return {sphere.name, std::move(sphere.level), make_colormap(colours), sphere.models, sphere.cameras};
}

}  // namespace oblong
