#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>

#include "tests/map/editor_formats.h"

namespace oblong::test {
namespace {

using Kind = EditorValue::Kind;

// A value at a path of names, and its type: "[]" is each value of a list, and what ends with '?' may be missing.
struct Member {
    std::string_view path;
    Kind kind = Kind::Text;
};

constexpr std::array kGame{
    Member{"version", Kind::Number},
    Member{"name"},
    Member{"icon?"},
    Member{"experimental?", Kind::Boolean},
    Member{"fileformats.[].format"},
    Member{"fileformats.[].initialmap?"},
    Member{"filesystem.searchpath"},
    Member{"filesystem.packageformat.format"},
    Member{"filesystem.packageformat.extension"},
    Member{"materials.root"},
    Member{"materials.extensions.[]"},
    Member{"materials.palette?"},
    Member{"materials.attribute?"},
    Member{"entities.definitions.[]"},
    Member{"entities.defaultcolor"},
    Member{"entities.setDefaultProperties?", Kind::Boolean},
    Member{"tags?.brush?.[].name"},
    Member{"tags?.brush?.[].match"},
    Member{"tags?.brush?.[].pattern"},
    Member{"tags?.brush?.[].material?"},
    Member{"tags?.brush?.[].attribs?.[]"},
    Member{"tags?.brushface?.[].name"},
    Member{"tags?.brushface?.[].match"},
    Member{"tags?.brushface?.[].pattern"},
    Member{"tags?.brushface?.[].attribs?.[]"},
    Member{"softMapBounds?"},
    Member{"compilationTools?.[].name"},
};
constexpr std::array kCompilation{
    Member{"version", Kind::Number},
    Member{"profiles.[].name"},
    Member{"profiles.[].workdir"},
    Member{"profiles.[].tasks.[].type"},
    Member{"profiles.[].tasks.[].enabled?", Kind::Boolean},
    Member{"profiles.[].tasks.[].stripTbProperties?", Kind::Boolean},
    Member{"profiles.[].tasks.[].treatNonZeroResultCodeAsError?", Kind::Boolean},
};
constexpr std::array kExport{Member{"target"}};
constexpr std::array kTool{Member{"tool"}, Member{"parameters"}};
constexpr std::array kEngine{Member{"version", Kind::Number}, Member{"profiles.[].id?"}, Member{"profiles.[].name"},
                             Member{"profiles.[].path"}, Member{"profiles.[].parameters"}};

void check_member(const EditorValue& value, std::string_view path, const Member& member) {
    if (path.empty()) {
        if (value.kind != member.kind) throw std::runtime_error(std::string(member.path) + ": another type");
        return;
    }
    const std::size_t end = std::min(path.find('.'), path.size());
    std::string name(path.substr(0, end));
    const std::string_view rest = path.substr(std::min(end + 1, path.size()));
    if (name == "[]") {
        for (const EditorValue& each : value.as_list()) check_member(each, rest, member);
        return;
    }
    if (name.ends_with('?')) {
        name.pop_back();
        if (value.kind == Kind::Map && !value.map.contains(name)) return;
    }
    check_member(value.at(name), rest, member);
}

void check_members(const EditorValue& value, std::span<const Member> members) {
    for (const Member& member : members) check_member(value, member.path, member);
}

void demand(bool holds, const std::string& what) {
    if (!holds) throw std::runtime_error("expected " + what);
}

std::size_t count_numbers(const std::string& text) {
    std::istringstream words(text);
    std::size_t count = 0;
    for (std::string word; words >> word; ++count)
        demand(word.find_first_not_of("-.0123456789") == std::string::npos, "a number, found " + word);
    return count;
}

const EditorValue* find(const EditorValue& map, const std::string& key) {
    const auto found = map.map.find(key);
    return found == map.map.end() ? nullptr : &found->second;
}

void check_tags(const EditorValue& tags) {
    std::set<std::string> names;
    for (const char* const where : {"brush", "brushface"}) {
        const EditorValue* const list = find(tags, where);
        if (list == nullptr) continue;
        for (const EditorValue& tag : list->as_list()) {
            demand(names.insert(tag.at("name").as_text()).second, "each tag once");
            demand(tag.at("match").as_text() == (std::string(where) == "brush" ? "classname" : "material"),
                   "a way to match");
            if (const EditorValue* const attributes = find(tag, "attribs"))
                for (const EditorValue& each : attributes->as_list())
                    demand(each.as_text() == "transparent", "an attribute that is known");
        }
    }
}

}  // namespace

EditorValue read_game_config(std::string_view text) {
    EditorValue game = evaluate(text);
    check_members(game, kGame);
    demand(game.at("version").as_number() == 9, "version 9");
    for (const EditorValue& each : game.at("fileformats").as_list()) {
        const std::string& format = each.at("format").as_text();
        demand(format == "Standard" || format == "Valve", "a format that oblong-map reads");
    }
    const std::size_t colours = count_numbers(game.at("entities").at("defaultcolor").as_text());
    demand(colours == 3 || colours == 4, "a colour of 3 or 4 numbers");
    const EditorValue* const bounds = find(game, "softMapBounds");
    demand(bounds == nullptr || count_numbers(bounds->as_text()) == 6, "a box of 6 numbers");
    if (const EditorValue* const tags = find(game, "tags")) check_tags(*tags);
    return game;
}

EditorValue read_compilation_config(std::string_view text) {
    EditorValue config = evaluate(text);
    check_members(config, kCompilation);
    demand(config.at("version").as_number() == 1, "version 1");
    for (const EditorValue& profile : config.at("profiles").as_list()) {
        for (const EditorValue& task : profile.at("tasks").as_list()) {
            const std::string& type = task.at("type").as_text();
            demand(type == "export" || type == "tool", "a task to export or of a tool");
            check_members(task, type == "export" ? std::span<const Member>(kExport) : kTool);
        }
    }
    return config;
}

EditorValue read_engine_config(std::string_view text) {
    EditorValue config = evaluate(text);
    check_members(config, kEngine);
    demand(config.at("version").as_number() == 1, "version 1");
    return config;
}

}  // namespace oblong::test
