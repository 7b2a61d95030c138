#include <ostream>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/programs/arguments.h"
#include "engine/programs/command_line.h"
#include "tools/accuracy/measured_level.h"
#include "tools/bench/benchmarks.h"
#include "tools/render/camera_list.h"

namespace {

using namespace oblong;

struct Options {
    std::string level, cameras, palette, mode = "320x200";
    std::string results;  ///< the file of --benchmark_out
};

void declare(CommandArguments& line, Options& options) {
    CommandOption level = line.add("--level", options.level, "whose frames are timed (default: a sphere in a room)");
    CommandOption cameras = line.add("--cameras", options.cameras, "its cameras, CSV: x,y,z,yaw,pitch[,roll]");
    level.need(cameras);
    cameras.need(level);
    line.add("--palette", options.palette, "768 bytes of red, green, blue (default: the demo level's)");
    line.add("--mode", options.mode, "pixels of the frames, WIDTHxHEIGHT");
}

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

/// A sphere of 288 facets in a room, one of the hard scenes of oblong-accuracy.
BenchLevel make_bench_level(const std::string& palette) {
    constexpr std::size_t kMostCameras = 8;
    const Palette colours = read_parsed(palette, read_palette);
    MeasuredLevel sphere = std::move(make_hard_scenes(colours, kMostCameras).back());
    return {sphere.name, std::move(sphere.level), make_colormap(colours), sphere.models, sphere.cameras};
}

/// Writes the file of --benchmark_out; Google Benchmark alone does not notice a full disk.
class FileReporter : public benchmark::JSONReporter {
  public:
    void Finalize() override {
        JSONReporter::Finalize();
        is_written = !GetOutputStream().flush().fail();
    }
    bool is_written = true;
};

/// The value of one of Google Benchmark's options, "--benchmark_NAME=VALUE"; empty if it is not given.
std::string value_of(std::span<char* const> arguments, const std::string& option) {
    std::string value;
    for (const std::string_view argument : arguments)
        if (argument.starts_with(option + "=")) value = argument.substr(option.size() + 1);
    return value;
}

void run_benchmarks(const Options& options) {
    ScreenMode mode;
    parse_mode_size(options.mode, mode);
    const BenchLevel level = options.level.empty() ? make_bench_level(options.palette)
                                                   : read_bench_level(options.level, options.cameras, options.palette);
    register_kernel_benchmarks();
    register_stage_benchmarks(level, mode);
    benchmark::AddCustomContext("level", level.name);
    benchmark::AddCustomContext("mode", options.mode);
    FileReporter file;
    if (benchmark::RunSpecifiedBenchmarks(nullptr, options.results.empty() ? nullptr : &file) == 0)
        throw UsageError("--benchmark_filter: no benchmark has such a name, expected one of --benchmark_list_tests");
    if (!file.is_written)
        throw FileError(options.results, "write", "failed, expected a writable file on a disk that is not full");
}

}  // namespace

int main(int argc, char** argv) {
    // Options that begin with --benchmark_ are Google Benchmark's, the others this program's.
    std::vector<char*> ours{argv[0]}, theirs{argv[0]};
    for (int i = 1; i < argc; ++i)
        (std::string_view(argv[i]).starts_with("--benchmark_") ? theirs : ours).push_back(argv[i]);
    Options options;
    options.results = value_of(theirs, "--benchmark_out");
    const std::string format = value_of(theirs, "--benchmark_out_format");
    auto count = static_cast<int>(theirs.size());
    benchmark::Initialize(&count, theirs.data());

    CommandLine line(
        "oblong-bench",
        "Times kernels and stages with Google Benchmark, whose options (--benchmark_filter=...) it takes.");
    declare(line, options);
    const auto run = [&] {
        if (!format.empty() && format != "json")
            throw UsageError("--benchmark_out_format: '" + format + "', expected json");
        if (options.palette.empty()) options.palette = assets_folder(argv[0]) + "/palette.lmp";
        run_benchmarks(options);
    };
    if (count > 1) {
        const auto refuse = [&] { throw UsageError(std::string(theirs[1]) + ": no option of Google Benchmark"); };
        return run_program("oblong-bench", refuse);
    }
    return line.run(static_cast<int>(ours.size()), ours.data(), run);
}
