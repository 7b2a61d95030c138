#include <algorithm>
#include <cstdio>

#include "engine/io/files.h"
#include "engine/level/bsp_read.h"
#include "engine/pictures/picture.h"
#include "engine/programs/arguments.h"
#include "engine/programs/command_line.h"
#include "game/program/program.h"
#include "tools/gallery/canvas.h"
#include "tools/gallery/page.h"
#include "tools/gallery/program/gallery_screen.h"
#include "tools/gallery/row.h"

namespace {

using namespace oblong;

struct PageOptions {
    std::string out = "gallery", assets, mode = "320x200", display = "4:3", preset = "bounded";
    std::vector<std::string> dials, ids;
};

/// Smaller pictures have no room for a scene between the header and the footer; on displays of other shapes scenes are
/// cut off.
void check_room(const ScreenMode& mode, const PageOptions& options) {
    if (mode.width_px < 160 || mode.height_px < 100)
        throw UsageError("--mode: '" + options.mode + "' has no room for the rows, expected at least 160x100");
    const double shape = number_of(mode.display);
    if (shape < 0.5 || shape > 2.4)
        throw UsageError("--display: '" + options.display + "' has no room for the rows, expected from 1:2 to 12:5");
}

void declare(CommandArguments& line, PageOptions& options) {
    line.add("--out", options.out, "folder for index.html and its pictures");
    line.add("--row", options.ids, "only this row, by its id; may be given several times");
    line.add("--assets", options.assets, "folder of demo.bsp and palette.lmp (default: the project's)");
    line.add("--mode", options.mode, "pixels of a picture, WIDTHxHEIGHT from 160x100");
    line.add("--display", options.display, "shape of the display, WIDTH:HEIGHT");
    line.add("--accuracy", options.preset, std::string(kPresetNames));
    line.add("--dial", options.dials, "NAME=VALUE, on top of --accuracy; may be given several times (README)");
}

std::vector<Row> chosen_rows(const std::vector<std::string>& ids) {
    std::vector<Row> rows = gallery_rows();
    if (ids.empty()) return rows;
    std::string known;
    for (const Row& row : rows) known += (known.empty() ? "" : ", ") + std::string(row.id);
    for (const std::string& id : ids)
        if (std::none_of(rows.begin(), rows.end(), [&](const Row& row) { return row.id == id; }))
            throw UsageError("--row: '" + id + "', expected one of " + known);
    std::erase_if(rows, [&](const Row& row) { return std::find(ids.begin(), ids.end(), row.id) == ids.end(); });
    return rows;
}

/// The values for each picture of a row: its start values, and all other values of its first parameter if that is a
/// choice of names.
std::vector<std::vector<std::int64_t>> values_of_pictures(const Row& row) {
    std::vector<std::vector<std::int64_t>> pictures{start_values(row)};
    if (row.parameters.empty() || row.parameters[0].choices.empty()) return pictures;
    for (std::int64_t choice = 0; choice <= row.parameters[0].most; ++choice) {
        if (choice == row.parameters[0].start) continue;
        pictures.push_back(start_values(row));
        pictures.back()[0] = choice;
    }
    return pictures;
}

/// Draws a row's pictures into the folder.
PageRow write_pictures(const Row& row, RowInput input, const std::string& folder) {
    PageRow shown{row, {}, {}};
    const ScreenMode& mode = input.mode;
    for (const auto& values : values_of_pictures(row)) {
        input.values = values;
        const std::string number = shown.pictures.empty() ? "" : "-" + std::to_string(shown.pictures.size());
        const std::string file = std::string(row.id) + number + ".png";
        const SidePicture picture(mode.width_px, mode.height_px);
        shown.figures.push_back(draw_row(row, input, 0, picture));
        shown.pictures.push_back({file, values.empty() ? "" : value_text(row.parameters[0], values[0])});
        write_file(folder + "/" + file,
                   encode_indexed_png(picture.indices, mode.width_px, mode.height_px, input.assets.colormap.palette));
    }
    return shown;
}

/// Prints the figures that differ from the expected ones; returns their number.
std::size_t report_wrong(const PageRow& shown) {
    std::size_t wrong = 0;
    for (const Figures& figures : shown.figures)
        for (const Figure& figure : figures) {
            if (figure.agrees) continue;
            ++wrong;
            std::fprintf(stderr, "oblong-gallery: %s: %s\n", std::string(shown.row.id).c_str(),
                         figure_text(figure).c_str());
        }
    return wrong;
}

void make_gallery(const PageOptions& options) {
    ScreenMode mode;
    parse_mode_size(options.mode, mode);
    mode.display = parse_display(options.display);
    check_room(mode, options);
    check_view(mode, Degrees::from_int(90));
    Settings settings;
    settings.accuracy = parse_accuracy(parse_preset(options.preset), options.dials);
    const std::vector<Row> rows = chosen_rows(options.ids);

    const Level level = read_parsed(options.assets + "/demo.bsp", read_bsp);
    const Colormap colormap = make_colormap(read_parsed(options.assets + "/palette.lmp", read_palette));
    const GalleryAssets assets{level, colormap, text_colours_of(colormap.palette)};
    make_folder(options.out);
    std::vector<PageRow> shown;
    std::size_t wrong = 0, pictures = 0;
    for (const Row& row : rows) {
        shown.push_back(write_pictures(row, {assets, mode, settings, {}}, options.out));
        wrong += report_wrong(shown.back());
        pictures += shown.back().pictures.size();
    }
    const std::string page = index_page(shown, mode);
    write_file(options.out + "/index.html", page);
    std::printf("%zu rows, %zu pictures: %s/index.html\n", rows.size(), pictures, options.out.c_str());
    if (wrong > 0) throw std::runtime_error(std::to_string(wrong) + " figures are not as expected");
}

}  // namespace

int main(int argc, char** argv) {
    if (std::any_of(argv, argv + argc, [](const char* word) { return std::string_view(word) == "--gallery"; }))
        return start_game(argc, argv, open_gallery);
    PageOptions options;
    CommandLine line("oblong-gallery",
                     "Draws all that the seeds name, a picture each, with an index page. With --gallery: in a window, "
                     "and the options are the game's (oblong --help).");
    declare(line, options);
    return line.run(argc, argv, [&] {
        if (options.assets.empty()) options.assets = assets_folder(argv[0]);
        make_gallery(options);
    });
}
