#include <algorithm>
#include <chrono>
#include <cstdio>
#include <deque>
#include <iterator>

#include "engine/base/input_error.h"
#include "engine/io/files.h"
#include "engine/programs/arguments.h"
#include "engine/programs/command_line.h"
#include "tools/accuracy/frame_times.h"
#include "tools/accuracy/measured_level.h"
#include "tools/accuracy/report.h"
#include "tools/render/camera_list.h"

namespace {

using namespace oblong;

struct Options {
    std::string out = ".", level, cameras, palette, page;
    bool is_quick = false, checks_page = false;
};

void declare(CommandArguments& line, Options& options) {
    line.add("--out", options.out, "folder for accuracy.html and accuracy.json");
    line.add_flag("--quick", options.is_quick, "fewer cameras, fewer rounds: under a minute");
    line.add("--page", options.page,
             "measure nothing but the presets' errors and operations, and put them into this page");
    line.add_flag("--check", options.checks_page, "leave the page as it is: fail if it says something else");
    const CommandOption level =
        line.add("LEVEL", options.level, "a level to measure besides the hard scenes and the demo");
    CommandOption cameras = line.add("--cameras", options.cameras, "its cameras, CSV: x,y,z,yaw,pitch[,roll]");
    cameras.need(level);
    line.add("--palette", options.palette, "its palette (default: the demo level's)").need(level);
}

/// Some of the cameras, spread over the list.
std::vector<Camera> thinned(const std::vector<Camera>& cameras, std::size_t most) {
    if (cameras.size() <= most) return cameras;
    std::vector<Camera> some;
    for (std::size_t i = 0; i < most; ++i) some.push_back(cameras[i * cameras.size() / most]);
    return some;
}

MeasuredLevel read_level(const std::string& path, const std::string& name, const std::string& cameras_path,
                         std::size_t most_cameras) {
    const std::vector<Camera> cameras =
        read_parsed(cameras_path, [](const auto& bytes) { return parse_cameras(bytes, Degrees::from_int(90)); });
    return read_parsed(
        path, [&](const auto& bytes) { return make_measured_level(name, "", bytes, thinned(cameras, most_cameras)); });
}

/// Colours that levels are drawn in.
struct Colours {
    Palette palette;
    Colormap colormap;

    explicit Colours(const std::string& path) : palette(read_parsed(path, read_palette)) {
        colormap = make_colormap(palette);
    }
};

/// The hard scenes, the demo level, and last the named level, which is read first, since it may be invalid.
std::deque<MeasuredLevel> read_levels(const Options& options, const std::string& assets, const Palette& demo_palette) {
    std::deque<MeasuredLevel> levels;
    const std::size_t most = options.is_quick ? 4 : 1000;
    if (!options.level.empty()) levels.push_back(read_level(options.level, options.level, options.cameras, most));
    levels.push_front(read_level(assets + "/demo.bsp", "demo level", assets + "/demo_cameras.csv", most));
    std::vector<MeasuredLevel> scenes = make_hard_scenes(demo_palette, options.is_quick ? 2 : 1000);
    std::move(scenes.rbegin(), scenes.rend(), std::front_inserter(levels));
    return levels;
}

/// The presets in the hard scenes and the demo level, without times.
void report_to_page(const Options& options, const std::string& assets) {
    const std::vector<std::uint8_t> bytes = read_file(options.page);
    const std::string page(bytes.begin(), bytes.end());
    with_table(page, options.page, "");  // an error before the work that takes long
    const Colours demo(assets + "/palette.lmp");
    const std::deque<MeasuredLevel> levels = read_levels({}, assets, demo.palette);
    std::vector<MeasuredPlace> places;
    for (const MeasuredLevel& level : levels) places.push_back({level, demo.palette, demo.colormap});
    map::ProgressLine progress("oblong-accuracy");
    const std::string table = preset_table(measure_all(make_configurations({}), places, {0, 1, false}, &progress));
    const std::string measured = with_table(page, options.page, table);
    if (!options.checks_page) return write_file(options.page, measured);
    if (page == measured) return;
    std::fputs(table.c_str(), stdout);
    throw InputError(options.page, "its table of presets is not what was measured, expected that on standard output");
}

void report_to_files(const Options& options, const std::string& assets) {
    if (options.checks_page) throw UsageError("--check needs --page, expected a page to check");
    if (!options.level.empty() && options.cameras.empty())
        throw UsageError("LEVEL needs --cameras, expected a file of cameras in the level");
    const auto start = std::chrono::steady_clock::now();
    const std::string json_file = options.out + "/accuracy.json", page_file = options.out + "/accuracy.html";
    make_folder(options.out);  // before the work that takes long
    check_writable(json_file);
    check_writable(page_file);
    const std::string demo_palette = assets + "/palette.lmp";
    const Colours demo(demo_palette), named(options.palette.empty() ? demo_palette : options.palette);
    const std::deque<MeasuredLevel> levels = read_levels(options, assets, demo.palette);
    std::vector<MeasuredPlace> places;
    for (const MeasuredLevel& level : levels) {
        const Colours& colours = &level == &levels.back() && !options.level.empty() ? named : demo;
        places.push_back({level, colours.palette, colours.colormap});
    }
    map::ProgressLine progress("oblong-accuracy");
    const Effort effort{options.is_quick ? 7 : 31, options.is_quick ? 2 : 4, options.is_quick,
                        options.is_quick ? 40u : 200u};
    Report report = measure_all(make_configurations(all_dials()), places, effort, &progress);
    report.machine = machine_name();
    report.compiler = compiler_name();
    report.seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
    const std::string json = report_json(report);
    write_file(json_file, json);
    write_file(page_file, report_page(json));
}

}  // namespace

int main(int argc, char** argv) {
    Options options;
    CommandLine line("oblong-accuracy", "Measures what each approximation costs, and writes it as a report.");
    declare(line, options);
    return line.run(argc, argv, [&] {
        const std::string assets = assets_folder(argv[0]);
        return options.page.empty() ? report_to_files(options, assets) : report_to_page(options, assets);
    });
}
