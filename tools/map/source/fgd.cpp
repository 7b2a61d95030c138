#include "tools/map/source/fgd.h"

#include <algorithm>
#include <set>

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
        return "{ \"path\": " + in_quotes(own.file) + ", \"scale\": " + std::to_string(own.scale) + " }";
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

std::string class_text(const EntityClass& row) {
    std::string text = head_of(row);
    std::set<std::string_view> seen{"classname", "origin"};
    const auto add = [&](std::span<const EntityKey> keys) {
        for (const EntityKey& key : keys)
            if (seen.insert(key.name).second) text += key_text(key);
    };
    for (const auto& keys : row.keys) add(keys);
    add(keys_of_all());
    return text + "]\n";
}

}  // namespace

std::string fgd_text() {
    std::string text = "// Oblong's classes and keys, written by `oblong-map --fgd`.\n";
    for (const EntityClass& row : entity_classes())
        if (!row.is_family()) text += "\n" + class_text(row);
    return text;
}

}  // namespace oblong::map
