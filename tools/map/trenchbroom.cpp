#include "tools/map/trenchbroom.h"

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "engine/io/files.h"
#include "engine/level/entity_classes.h"

namespace oblong::map {
namespace {

std::string in_quotes(std::string_view text) {
    std::string quoted = "\"" + std::string(text) + "\"";
    std::replace(quoted.begin(), quoted.end(), '`', '\'');
    return quoted;
}

std::string described(std::string_view does, std::string_view since) {
    return in_quotes((does.empty() ? "Quake's, without effect here" : std::string(does)) + since_text(since));
}

std::string_view type_of(const EntityKey& key) {
    if (key.kind == KeyKind::Flags) return "flags";
    if (!key.values.empty()) return "choices";
    if (key.kind == KeyKind::Name) return "target_source";
    if (key.kind == KeyKind::Target || key.kind == KeyKind::Place) return "target_destination";
    if (key.kind == KeyKind::Whole) return "integer";
    return key.kind == KeyKind::Numbers && key.most == 1 ? "float" : "string";
}

// Quoted for TrenchBroom's reader: all but whole numbers.
std::string default_of(const EntityKey& key) {
    if (key.usual.empty()) return "";
    return " : " + (type_of(key) == "integer" ? std::string(key.usual) : in_quotes(key.usual));
}

std::string values_of(std::span<const KeyValue> values, bool are_flags) {
    std::string text;
    for (const KeyValue& value : values)
        text += "\t\t" + (are_flags ? std::string(value.value) : in_quotes(value.value)) + " : " +
                in_quotes(value.does) + (are_flags ? " : 0\n" : "\n");
    return text;
}

std::string key_text(const EntityKey& key) {
    const std::string name(key.name.substr(0, key.name.find('#'))), type(type_of(key));
    std::string text = "\t" + name + "(" + type + ")";
    if (key.kind == KeyKind::Flags) {
        const std::span<const KeyValue> of_all = find_entity_key({}, key.name)->values;
        const bool is_of_class = key.values.data() != of_all.data();
        text += " =\n\t[\n" + values_of(key.values, true) + (is_of_class ? values_of(of_all, true) : "");
        return text + "\t]\n";
    }
    text += " : " + described(key.does, key.since) + default_of(key);
    return text + (key.values.empty() ? "" : " =\n\t[\n" + values_of(key.values, false) + "\t]") + "\n";
}

std::string model_text(const ClassModel& model) {
    std::string text = "{ \"path\": " + in_quotes(model.file);
    if (model.frame != 0) text += ", \"frame\": " + std::to_string(model.frame);
    if (model.skin != 0) text += ", \"skin\": " + std::to_string(model.skin);
    return text + " }";
}

// An expression for an entity's model. It ignores the kind of world, which only affects keys.
std::string model_of(const EntityClass& row) {
    const OwnModel& own = row.own_model;
    if (row.role == ClassRole::TriangleModel) return R"({ "path": model, "frame": frame, "skin": skin })";
    if (!own.file.empty())
        return "{ \"path\": " + in_quotes(own.file) +
               ", \"scale\": " + std::string(find_entity_key(row, "scale")->usual) + " }";
    std::string choices;
    for (const ClassModel& model : row.models) {
        if (!choices.empty()) choices += ", ";
        if (model.spawn_flags != 0) choices += "spawnflags & " + std::to_string(model.spawn_flags) + " -> ";
        choices += model_text(model);
    }
    return row.models.size() > 1 ? "{{ " + choices + " }}" : choices;
}

std::string corner_text(const std::array<std::int16_t, 3>& corner) {
    return std::to_string(corner[0]) + " " + std::to_string(corner[1]) + " " + std::to_string(corner[2]);
}

std::string head_of(const EntityClass& row) {
    const bool is_brush = row.shape == ClassShape::WorldModel || row.shape == ClassShape::Brush;
    std::string text = is_brush ? "@SolidClass" : "@PointClass";
    if (row.box.mins != row.box.maxs)
        text += " size(" + corner_text(row.box.mins) + ", " + corner_text(row.box.maxs) + ")";
    if (const std::string model = model_of(row); !model.empty()) text += " model(" + model + ")";
    return text + " = " + std::string(row.name) + " : " + described(row.does, row.since) + "\n[\n";
}

// `own`: of the game's class that the row is for.
std::string class_text(const EntityClass& row, const OwnClass& own = {}) {
    std::string text = head_of(row);
    std::set<std::string_view> seen{"classname", "origin"};
    const auto add = [&](std::span<const EntityKey> keys) {
        for (EntityKey key : keys) {
            for (const auto& [name, value] : own.values)
                if (name == key.name) key.usual = value;
            if (seen.insert(key.name).second) text += key_text(key);
        }
    };
    for (const auto& keys : row.keys) add(keys);
    add(keys_of_all());
    return text + "]\n";
}

std::string own_class_text(const std::string& name, const OwnClass& own) {
    EntityClass row = *find_entity_class(own.is);
    row.name = name;
    if (!own.does.empty()) row.does = own.does;
    return class_text(row, own);
}

namespace fs = std::filesystem;

fs::path without_tilde(const std::string& folder) {
    const char* const home = std::getenv("HOME");
    if (!folder.starts_with("~/")) return folder;
    if (home == nullptr) throw FileError(folder, "HOME", "is not set, expected the user's folder, or a folder by name");
    return fs::path(home) / folder.substr(2);
}

// For a quoted string in one of the editor's files.
std::string escaped(const std::string& text) {
    std::string out;
    for (const char letter : text) {
        if (letter == '"' || letter == '\\') out += '\\';
        out += letter;
    }
    return out;
}

std::string replaced(std::string text, const std::string& part, const std::string& by) {
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + by.size()))
        text.replace(at, part.size(), by);
    return text;
}

void copy_folder(const fs::path& from, const fs::path& to) {
    make_folder(to.string());
    for (const fs::directory_entry& file : fs::directory_iterator(from))
        if (file.is_regular_file()) write_file((to / file.path().filename()).string(), read_file(file.path().string()));
}

// Numbered, so that files that were kept earlier stay.
std::string free_name_beside(const fs::path& path) {
    std::string name = path.string() + ".old";
    for (int number = 2; fs::exists(fs::symlink_status(name)); ++number)
        name = path.string() + ".old" + std::to_string(number);
    return name;
}

void write_kept(const fs::path& path, const std::string& text) {
    if (!fs::exists(path) || read_text(path.string()) == text) return write_file(path.string(), text);
    const std::string old = free_name_beside(path);
    replace_file(path.string(), old, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
    std::cout << path.string() << " was changed: kept as " << old << '\n';
}

}  // namespace

std::string fgd_text(const OwnClasses& own) {
    std::string text = std::string(kFgdBeginning) + ", written by `oblong-map --fgd`.\n";
    for (const EntityClass& row : entity_classes())
        if (!row.is_family()) text += "\n" + class_text(row);
    for (const auto& [name, its_class] : own) text += "\n" + own_class_text(name, its_class);
    return text;
}

void install_trenchbroom(const std::string& folder, const char* called_as, const OwnClasses& own) {
    const fs::path to = fs::absolute(without_tilde(folder)), assets = fs::absolute(assets_folder(called_as)),
                   programs = fs::absolute(program_folder(called_as));
    make_folder((to / "assets" / "gfx").string());
    for (const char* const name :
         {"GameConfig.cfg", "CompilationProfiles.cfg", "GameEngineProfiles.cfg", "initial_valve.map"}) {
        std::string text = read_text((assets / "trenchbroom" / name).string());
        text = replaced(text, "@oblong-map@", escaped((programs / "oblong-map").string()));
        text = replaced(text, "@oblong@", escaped((programs / "oblong").string()));
        text = replaced(text, "@assets@", escaped(assets.string()));
        write_kept(to / name, text);
    }
    write_file((to / "Icon.png").string(), read_file((assets / "trenchbroom" / "Icon.png").string()));
    write_file((to / "Oblong.fgd").string(), fgd_text(own));
    write_file((to / "assets" / "gfx" / "palette.lmp").string(), read_file((assets / "palette.lmp").string()));
    copy_folder(assets / "models", to / "assets" / "models");
    std::cout << "TrenchBroom's configuration for Oblong is in " << to.string()
              << ". Start the editor again, and choose Oblong for a new map.\n";
}

}  // namespace oblong::map
