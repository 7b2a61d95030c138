#include "tests/map/editor_formats.h"

#include <algorithm>
#include <array>
#include <set>
#include <span>
#include <sstream>
#include <stdexcept>

#include "tests/support/patterns.h"

namespace oblong::test {
namespace {

using nlohmann::json;
using Kind = json::value_t;

// A value at a path of names, and its type: "[]" is each value of a list, and what ends with '?' may be missing.
struct Member {
    std::string_view path;
    Kind kind = Kind::string;
};

constexpr std::array kGame{
    Member{"version", Kind::number_unsigned},
    Member{"name"},
    Member{"icon?"},
    Member{"experimental?", Kind::boolean},
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
    Member{"entities.setDefaultProperties?", Kind::boolean},
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
    Member{"version", Kind::number_unsigned},
    Member{"profiles.[].name"},
    Member{"profiles.[].workdir"},
    Member{"profiles.[].tasks.[].type"},
    Member{"profiles.[].tasks.[].enabled?", Kind::boolean},
    Member{"profiles.[].tasks.[].stripTbProperties?", Kind::boolean},
    Member{"profiles.[].tasks.[].treatNonZeroResultCodeAsError?", Kind::boolean},
};
constexpr std::array kExport{Member{"target"}};
constexpr std::array kTool{Member{"tool"}, Member{"parameters"}};
constexpr std::array kEngine{Member{"version", Kind::number_unsigned}, Member{"profiles.[].id?"},
                             Member{"profiles.[].name"}, Member{"profiles.[].path"}, Member{"profiles.[].parameters"}};

void demand(bool holds, const std::string& what) {
    if (!holds) throw std::runtime_error("expected " + what);
}

void check_member(const json& value, std::string_view path, const Member& member) {
    if (path.empty()) return demand(value.type() == member.kind, "another type of " + std::string(member.path));
    const std::size_t end = std::min(path.find('.'), path.size());
    std::string name(path.substr(0, end));
    const std::string_view rest = path.substr(std::min(end + 1, path.size()));
    if (name == "[]") {
        demand(value.is_array(), "a list for " + std::string(member.path));
        for (const json& each : value) check_member(each, rest, member);
        return;
    }
    if (name.ends_with('?')) {
        name.pop_back();
        if (value.is_object() && !value.contains(name)) return;
    }
    check_member(value.at(name), rest, member);
}

void check_members(const json& value, std::span<const Member> members) {
    for (const Member& member : members) check_member(value, member.path, member);
}

// For the editor '}}' is one token, whatever it stands behind, and a backslash before another letter stands for itself.
json read_config(std::string_view text, std::span<const Member> members, int version) {
    demand(text.find("}}") == std::string_view::npos, "a blank between '}' and '}'");
    const std::string as_json =
        with_replaced(with_replaced(std::string(text), R"(\\(?!["\\]))", R"(\\)"), R"(\[ scale \])", R"([ "scale" ])");
    std::vector<std::set<std::string>> keys;  // of the maps around a place
    const auto check_key = [&keys](int, json::parse_event_t event, const json& parsed) {
        if (event == json::parse_event_t::object_start) keys.emplace_back();
        if (event == json::parse_event_t::object_end) keys.pop_back();
        if (event == json::parse_event_t::key) demand(keys.back().insert(parsed).second, "each key once");
        return true;
    };
    json config = json::parse(as_json, check_key, true, true);
    check_members(config, members);
    demand(config.at("version") == version, "version " + std::to_string(version));
    return config;
}

bool are_numbers(const std::string& text, const std::string& counts) {
    return !whole_match(text, "[-.0-9]+( [-.0-9]+){" + counts + "}").empty();
}

void check_tags(const json& tags) {
    std::set<std::string> names;
    for (const auto& [where, list] : tags.items()) {
        for (const json& tag : list) {
            demand(names.insert(tag.at("name")).second, "each tag once");
            demand(tag.at("match") == (where == "brush" ? "classname" : "material"), "a way to match");
            for (const json& attribute : tag.value("attribs", json::array()))
                demand(attribute == "transparent", "an attribute that is known");
        }
    }
}

// The lines of an FGD file, in the only order of its parts that Oblong writes.
class FgdLines {
  public:
    explicit FgdLines(std::string_view text) : text_(std::string(text)) {}

    const std::string& line() const { return line_; }
    bool next() {
        ++number_;
        return static_cast<bool>(std::getline(text_, line_));
    }
    Groups match(const std::string& pattern) const {
        const Groups parts = whole_match(line_, pattern);
        expect(!parts.empty(), pattern);
        return parts;
    }
    void expect(bool holds, const std::string& what) const {
        demand(holds, what + " in line " + std::to_string(number_) + ": " + line_);
    }
    // Reads what stands in brackets, a line at a time.
    void read_list(const std::string& indent, const auto& read) {
        expect(next() && line_ == indent + "[", "'['");
        while (next() && line_ != indent + "]") read();
        expect(line_ == indent + "]", "']'");
    }

  private:
    std::istringstream text_;
    std::string line_;
    int number_ = 0;
};

// What follows a key of this type: its description, and the default that the editor reads without a warning.
std::string definition_of(const std::string& type) {
    const std::string text = R"re("[^"]*")re";
    if (type == "flags") return " =";
    if (type == "integer") return " : " + text + R"re((?: : -?\d+)?)re";
    if (type == "float") return " : " + text + R"re((?: : "-?[.0-9]+")?)re";
    return " : " + text + "(?: : " + text + ")?" + (type == "choices" ? " =" : "");
}

// A model, perhaps only for entities with a flag (group 1); its path is a text or the key "model" (group 2).
const std::string kModel =
    R"re((?:spawnflags & (\d+) -> )?\{ "path": (model|"[^"]*")(?:, "(?:frame|skin|scale)": (?:frame|skin|[.0-9]+))* \})re";

}  // namespace

std::string interpolated(const std::string& text, const EditorVariables& variables) {
    std::string rest = text, out;
    for (const Groups& name : all_matches(text, R"(\$\{(\w+)\})")) {
        const std::size_t at = rest.find(name[0]);
        out += rest.substr(0, at) + variables.at(name[1]);
        rest = rest.substr(at + name[0].size());
    }
    demand(rest.find("${") == std::string::npos, "a name and '}' behind '${'");
    return out + rest;
}

json read_game_config(std::string_view text) {
    json game = read_config(text, kGame, 9);
    for (const json& each : game.at("fileformats"))
        demand(each.at("format") == "Standard" || each.at("format") == "Valve", "a format that oblong-map reads");
    demand(are_numbers(game.at("entities").at("defaultcolor"), "2,3"), "a colour of 3 or 4 numbers");
    demand(are_numbers(game.value("softMapBounds", "0 0 0 0 0 0"), "5"), "a box of 6 numbers");
    check_tags(game.value("tags", json::object()));
    return game;
}

json read_compilation_config(std::string_view text) {
    json config = read_config(text, kCompilation, 1);
    for (const json& profile : config.at("profiles")) {
        for (const json& task : profile.at("tasks")) {
            const bool is_export = task.at("type") == "export";
            demand(is_export || task.at("type") == "tool", "a task to export or of a tool");
            check_members(task, is_export ? std::span<const Member>(kExport) : kTool);
        }
    }
    return config;
}

json read_engine_config(std::string_view text) {
    return read_config(text, kEngine, 1);
}

std::vector<EditorClass> read_fgd(std::string_view text) {
    const std::string corner = R"re(-?\d+ -?\d+ -?\d+)re";
    const std::string head = R"re((@SolidClass|@PointClass)( size\()re" + corner + ", " + corner +
                             R"re(\))?(?: model\((.*)\))? = (\w+) : "[^"]*")re";
    std::vector<EditorClass> classes;
    FgdLines lines(text);
    std::set<std::string> seen;
    const auto expect_once = [&](const std::string& name) { lines.expect(seen.insert(name).second, name + " once"); };
    while (lines.next()) {
        if (lines.line().empty() || lines.line().starts_with("//")) continue;
        const Groups parts = lines.match(head);
        EditorClass& its = classes.emplace_back(EditorClass{parts[4], parts[3], {}});
        lines.expect(parts[1] == "@PointClass" || (parts[2].empty() && parts[3].empty()), "no size of brushes");
        if (!its.model.empty()) model_path(its.model, {{"model", ""}, {"spawnflags", "-1"}});
        expect_once(its.name);
        lines.read_list("", [&] {
            const Groups key = lines.match(R"re(\t(\w+)\((\w+)\)(.*))re");
            const std::string name = its.name + " " + key[1], type = key[2];
            lines.expect(!whole_match(key[3], definition_of(type)).empty(), definition_of(type));
            expect_once(name);
            its.keys[key[1]] = type;
            if (type != "flags" && type != "choices") return;
            const std::string value =
                type == "flags" ? R"re(\t\t(\d+) : "[^"]*" : [01])re" : R"re(\t\t("[^"]*") : "[^"]*")re";
            lines.read_list("\t", [&] { expect_once(name + " " + lines.match(value)[1]); });
        });
    }
    return classes;
}

std::string model_path(const std::string& expression, const EditorVariables& keys) {
    const std::string all = kModel + R"re(|\{\{ )re" + kModel + "(?:, " + kModel + R"re()* \}\})re";
    demand(!whole_match(expression, all).empty(), "a model: " + expression);
    for (const Groups& model : all_matches(expression, kModel)) {
        if (!model[1].empty() && (std::stoi(model[1]) & std::stoi(keys.at("spawnflags"))) == 0) continue;
        const std::string& path = model[2];
        return path == "model" ? keys.at("model") : path.substr(1, path.size() - 2);
    }
    throw std::runtime_error("expected a model: " + expression);
}

}  // namespace oblong::test
