#include <algorithm>
#include <array>
#include <filesystem>
#include <iostream>
#include <thread>

#include "engine/io/files.h"
#include "engine/level/entity_classes.h"
#include "engine/platform/worker_threads.h"
#include "engine/programs/arguments.h"
#include "engine/programs/command_line.h"
#include "engine/programs/game_definition.h"
#include "engine/surface/palette.h"
#include "tools/map/compile.h"
#include "tools/map/source/changed_part.h"
#include "tools/map/source/checks.h"
#include "tools/map/source/entities.h"
#include "tools/map/source/external_maps.h"
#include "tools/map/texture_sources.h"
#include "tools/map/tree/bsp_file.h"
#include "tools/map/trenchbroom.h"
#include "tools/map/work_sharing.h"
#include "tools/texture/texture_files.h"

namespace {

using namespace oblong;

struct Arguments {
    std::string input, output, fgd, game, portals, trenchbroom, only, since, reads;
    map::TextureSources textures;
    std::int64_t threads = 0;  // 0: one for each processor
    bool is_fast = false, is_strict = false, has_dirt = false, has_bounce = false;
};

void declare(CommandArguments& line, Arguments& arguments) {
    const CommandOption input =
        line.add("IN.map", arguments.input, "the level's source: Quake .map, Standard or Valve 220");
    line.add("-o,--out", arguments.output,
             "the level to write: OUT.bsp, version 29, or BSP2 if it is too large for that");
    line.add(
        "--wad", arguments.textures.wads,
        "a WAD2 file of textures or a folder of pictures; may be given more than once. Default: what the key wad of "
        "the worldspawn names");
    line.add("--glow", arguments.textures.glowing,
             "a texture of a folder whose colours may glow; may be given more than once");
    line.add("--dither", arguments.textures.dither, "of a folder's pictures: none or floyd-steinberg");
    line.add("--palette", arguments.textures.palette,
             "of a folder's pictures; default: palette.lmp in the folder, else that of --game, else Oblong's");
    const CommandOption fgd =
        line.add("--fgd", arguments.fgd, "writes the classes and keys that editors show, and compiles nothing")
            .exclude(input);
    line.add("--install-trenchbroom", arguments.trenchbroom,
             "a folder in which to write TrenchBroom's configuration for Oblong")
        .accept_no_value(map::kTrenchBroomFolder)
        .exclude(input)
        .exclude(fgd);
    line.add("--game", arguments.game, "a folder whose game.json has classes and a palette of its own");
    const CommandOption portals = line.add("--prt", arguments.portals, "writes the portals too, as a .prt file");
    line.add("--only", arguments.only,
             "entities, light or vis: compiles only that part, and keeps the rest of an existing OUT.bsp with the same "
             "brushes")
        .exclude(line.add("--since", arguments.since,
                          "the source that an existing OUT.bsp is of: compiles only what has changed since")
                     .exclude(portals));
    line.add("--reads", arguments.reads, "a file to write: the names of all other files that were read, one per line");
    line.add("--threads", arguments.threads,
             "number of threads; default: one per processor. The level is the same for any number")
        .limit(1, 64);
    line.add_flag("--fast", arguments.is_fast,
                  "a draft: less exact visibility and light; large bodies collide as players do; a leak is a warning");
    line.add_flag("--bounce", arguments.has_bounce, "surfaces reflect light once, as with worldspawn's _bounce 1");
    line.add_flag("--dirt", arguments.has_dirt, "corners get less light, as with worldspawn's _dirt 1");
    line.add_flag("--strict", arguments.is_strict, "warnings are errors");
}

bool makes_portals(map::CompilePart part) {
    return part == map::CompilePart::All || part == map::CompilePart::Visibility;
}

// Prints warnings as they come, and counts them.
class Reporter {
  public:
    explicit Reporter(const Arguments& arguments) : arguments_(arguments) {}
    Reporter(const Reporter&) = delete;
    Reporter& operator=(const Reporter&) = delete;
    // Before an error, too.
    ~Reporter() { print_all(); }

    void print() {
        print_all();
        if (arguments_.is_strict && count_ > 0)
            throw InputError("--strict", counted() + ", expected none: correct the level, or compile without --strict");
    }

    void print_all() {
        progress.clear();
        for (const map::Warning& warning : warnings.take()) {
            std::cerr << "oblong-map: " << arguments_.input << ": line " << warning.line
                      << ": warning: " << warning.what << '\n';
            ++count_;
            unread_ += warning.is_unread;
        }
    }

    void print_summary(const map::BspFile& bsp, map::CompilePart part, const map::PortalFile& portals) {
        std::cout << arguments_.output << ": " << map::summary_of(bsp);
        if (makes_portals(part)) {
            const map::WidestView widest = map::widest_view(bsp);
            std::cout << ", " << portals.count << " portals, at most " << widest.faces << " faces in sight, around "
                      << map::point_text(widest.place);
        }
        std::cout << "; " << counted() << "; " << progress.times() << '\n';
    }

    map::Warnings warnings;
    map::ProgressLine progress{"oblong-map"};

  private:
    std::string counted() const {
        const std::string all = std::to_string(count_) + (count_ == 1 ? " warning" : " warnings");
        return unread_ == 0 ? all : all + " (" + std::to_string(unread_) + " of what nothing reads)";
    }

    const Arguments& arguments_;
    int count_ = 0, unread_ = 0;
};

// Of game.json, or where the game looks for one beside its levels; empty: none.
std::string palette_of_game(const std::string& folder, const GameDefinition& game) {
    if (!game.palette.empty()) return game.palette;
    for (const char* const usual : {"palette.lmp", "gfx/palette.lmp"})
        if (const std::filesystem::path file = std::filesystem::path(folder) / usual; std::filesystem::exists(file))
            return file.string();
    return "";
}

// With the classes' meanings and values in the game; the level keeps the original classes.
std::vector<map::MapEntity> with_known_classes(std::vector<map::MapEntity> entities, const GameDefinition& game) {
    for (map::MapEntity& entity : entities) {
        const auto own = game.classes.find(entity.value("classname"));
        if (own == game.classes.end()) continue;
        for (auto& pair : entity.pairs)
            if (pair.key == "classname") pair.value = own->second.is;
        for (const auto& [key, value] : own->second.values)
            if (!entity.has(key)) entity.pairs.push_back({key, value, entity.line});
    }
    return entities;
}

// The folders below which the game looks for what the level names; beside its source it may be copied later.
std::vector<std::string> game_folders_of(const Arguments& arguments, const char* called_as) {
    std::vector<std::string> folders{arguments.game.empty() ? assets_folder(called_as) : arguments.game};
    for (const std::filesystem::path file : {arguments.output, arguments.input})
        for (const char* const from : {".", ".."}) folders.push_back((file.parent_path() / from).string());
    return folders;
}

// Sounds and music that are missing; the game is silent then.
void find_missing_files(const std::vector<map::MapEntity>& entities, const std::vector<std::string>& folders,
                        map::Warnings& warnings) {
    for (const map::MapEntity& entity : entities) {
        const EntityClass* const its_class = find_entity_class(entity.value("classname"));
        for (const map::MapPair& pair : entity.pairs) {
            if ((pair.key != "noise" && pair.key != "music") || pair.value.empty() || !its_class) continue;
            const EntityKey* const row = find_entity_key(*its_class, pair.key);
            if (row == nullptr || !find_below(folders, pair.value).empty()) continue;
            warnings.add(pair.line, "'" + pair.key + "' is '" + pair.value + "', but there is no such file below " +
                                        folders.front() + " or the level's folder");
        }
    }
}

map::CompilePart parse_part(const std::string& name) {
    // CompilePart's values after All, in their order.
    constexpr std::array<std::string_view, 3> kAfterAll{"entities", "light", "vis"};
    return static_cast<map::CompilePart>(name.empty() ? 0 : 1 + parse_choice("--only", name, kAfterAll));
}

map::CompilePart part_to_compile(const Arguments& arguments, const std::vector<map::MapEntity>& entities) {
    if (arguments.since.empty()) return parse_part(arguments.only);
    return naming_file(arguments.since,
                       [&] { return changed_part(map::parse_map(read_text(arguments.since)), entities); });
}

// What the source at `path` names; `files` receives its path before it is read.
map::ExternalSource read_external(const std::string& name, const std::string& path, int line,
                                  std::vector<std::string>& files) {
    std::string below = name;
    std::replace(below.begin(), below.end(), '\\', '/');
    const std::string& found = files.emplace_back((std::filesystem::path(path).parent_path() / below).string());
    if (!std::filesystem::is_regular_file(found))
        throw InputError(at_line(line), "\"_external_map\" names '" + name + "', which is not at " + found +
                                            ", expected a map source there");
    return {std::filesystem::weakly_canonical(found).string(), read_text(found)};
}

map::BspFile read_former(const std::string& file) {
    if (!std::filesystem::exists(file))
        throw FileError(file, "--only", "there is no such level yet: compile it once without --only");
    return naming_file(file, [&] { return map::from_bytes(read_text(file)); });
}

// The file is of the level beside it: one of an earlier leak goes, unless this part of the level does not tell.
void keep_points(const Arguments& arguments, map::CompilePart part, const std::vector<map::Point>& leak_path) {
    const std::string points = std::filesystem::path(arguments.output).replace_extension(".pts").string();
    if (!leak_path.empty()) {
        std::string text;
        for (const map::Point& point : leak_path) text += map::point_text(point) + "\n";
        write_file(points, text);
        std::cerr << "oblong-map: " << points << " has the path to the void\n";
    } else if (part == map::CompilePart::All && points != arguments.output &&
               std::filesystem::is_regular_file(points)) {
        std::filesystem::remove(points);
    }
}

// `files`: receives the names of the other files before they are read.
void compile(const Arguments& arguments, const std::string& text, const char* called_as,
             std::vector<std::string>& files) {
    Reporter reporter(arguments);
    std::vector<map::MapEntity> entities = map::parse_map(text, &reporter.warnings);
    const map::CompilePart part = part_to_compile(arguments, entities);
    map::include_external_maps(
        entities, std::filesystem::weakly_canonical(arguments.input).string(),
        [&](const std::string& name, const std::string& path, int line) {
            return read_external(name, path, line, files);
        },
        reporter.warnings);
    map::TextureSources textures = arguments.textures;
    GameDefinition game;
    if (!arguments.game.empty()) {
        game = read_game_definition(arguments.game);
        textures.game_palette = palette_of_game(arguments.game, game);
    }
    const std::vector<map::Wad> wads =
        map::read_texture_sources(textures, entities.front(), arguments.input, called_as, files, reporter.warnings);
    check_replaces_none("--prt", arguments.portals, files);
    const auto known = with_known_classes(entities, game);
    map::find_warnings(known, reporter.warnings);
    find_missing_files(known, game_folders_of(arguments, called_as), reporter.warnings);
    reporter.print();
    const int processors = std::max(1, static_cast<int>(std::thread::hardware_concurrency()));
    WorkerThreads workers(arguments.threads > 0 ? static_cast<int>(arguments.threads) : processors);
    map::PortalFile portals;
    portals.has_text = !arguments.portals.empty();
    Palette palette;
    const bool has_bounce = arguments.has_bounce || map::number_of(entities.front(), "_bounce", 0) >= 1;
    if (has_bounce) palette = read_parsed(map::palette_file(textures, called_as), read_palette);
    std::vector<map::Point> leak_path;
    map::CompileOptions options{.is_fast = arguments.is_fast,
                                .has_dirt = arguments.has_dirt,
                                .has_bounce = arguments.has_bounce,
                                .palette = has_bounce ? &palette : nullptr,
                                .warnings = &reporter.warnings,
                                .before_long_passes = [&] { reporter.print(); },
                                .workers = &workers,
                                .progress = &reporter.progress,
                                .portals = &portals,
                                .leak_path = &leak_path,
                                .part = part};
    if (part != map::CompilePart::All) options.former = read_former(arguments.output);
    try {
        const map::BspFile level = map::compile_map(std::move(entities), wads, options);
        reporter.print();
        if (!arguments.portals.empty()) write_file(arguments.portals, portals.text);
        write_file(arguments.output, map::to_bytes(level));
        keep_points(arguments, part, leak_path);
        reporter.print_summary(level, part, portals);
    } catch (const map::LeakError& leak) {
        reporter.progress.clear();
        keep_points(arguments, part, leak.path);
        throw InputError(leak.where, std::string(leak.what()) + "; a draft is made in spite of it (--fast)");
    }
}

void compile_to_file(const Arguments& arguments, const char* called_as) {
    if (arguments.input.empty()) throw UsageError("IN.map is required");
    if (arguments.output.empty()) throw UsageError("--out is required");
    parse_dither(arguments.textures.dither);
    std::vector<std::string> others = arguments.textures.wads;
    others.insert(others.end(), {arguments.input, arguments.since, arguments.textures.palette});
    for (const auto& [option, file] : {std::pair("--out", arguments.output), std::pair("--prt", arguments.portals),
                                       std::pair("--reads", arguments.reads)}) {
        check_replaces_none(option, file, others);
        others.push_back(file);
    }
    check_replaces_only("--out", arguments.output, "level", {std::string_view("\x1d\0\0\0", 4), "BSP2"});
    if (!arguments.portals.empty() && !makes_portals(parse_part(arguments.only)))
        throw UsageError("--prt: --only " + arguments.only + " makes no portals, expected --only vis, or none");
    for (const std::string& file : {arguments.output, arguments.portals, arguments.reads})
        if (!file.empty()) check_writable(file);
    const std::string text = read_text(arguments.input);
    std::vector<std::string> files;
    const auto tell_files = [&] {
        check_replaces_none("--reads", arguments.reads, files);
        std::string names;
        for (const std::string& file : files) names += file + "\n";
        if (!arguments.reads.empty()) write_file(arguments.reads, names);
    };
    try {
        naming_file(arguments.input, [&] { compile(arguments, text, called_as, files); });
    } catch (...) {
        tell_files();
        throw;
    }
    tell_files();
}

}  // namespace

int main(int argc, char** argv) {
    Arguments arguments;
    CommandLine line("oblong-map", "Compiles the source of a level to a Quake BSP file (version 29).");
    declare(line, arguments);
    return line.run(argc, argv, [&] {
        if (arguments.fgd.empty() && arguments.trenchbroom.empty()) return compile_to_file(arguments, argv[0]);
        const map::OwnClasses own =
            arguments.game.empty() ? map::OwnClasses{} : read_game_definition(arguments.game).classes;
        if (!arguments.trenchbroom.empty()) return map::install_trenchbroom(arguments.trenchbroom, argv[0], own);
        check_replaces_only("--fgd", arguments.fgd, "FGD of Oblong", {map::kFgdBeginning});
        write_file(arguments.fgd, map::fgd_text(own));
    });
}
