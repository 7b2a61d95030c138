#include "tools/map/source/checks.h"

#include <algorithm>
#include <array>
#include <unordered_map>
#include <unordered_set>
#include <utility>
#include <vector>

#include "engine/base/text.h"
#include "engine/level/entity_classes.h"
#include "engine/level/left_out.h"
#include "engine/scene/level_effects.h"
#include "tools/map/source/brush.h"
#include "tools/map/source/entities.h"

namespace oblong::map {
namespace {

std::string as_quoted(std::string_view text) {
    constexpr std::size_t kMost = 60;
    return "'" + std::string(text.substr(0, kMost)) + (text.size() > kMost ? "...'" : "'");
}

std::string with_article(std::string_view name) {
    const bool is_vowel = std::string_view("aeiou").find(name.front()) != std::string_view::npos;
    return (is_vowel ? "an " : "a ") + std::string(name);
}

std::string nearest_class(std::string_view wanted) {
    NearestName nearest(wanted);
    for (const EntityClass& row : entity_classes()) nearest.add(row.name);
    return nearest.text();
}

std::string nearest_key(const EntityClass& its_class, std::string_view wanted) {
    NearestName nearest(wanted);
    for (const auto& keys : its_class.keys)
        for (const EntityKey& row : keys)
            if (!row.does.empty()) nearest.add(row.name);
    for (const EntityKey& row : keys_of_all()) nearest.add(row.name);
    return nearest.text();
}

constexpr std::array<std::string_view, 4> kTargetKeys{"target", "target2", "killtarget", "look_at"};

class Checker {
  public:
    Checker(const std::vector<MapEntity>& entities, Warnings& warnings) : entities_(entities), warnings_(warnings) {
        for (const MapEntity& entity : entities) {
            name(entity, entity.value("targetname"));
            for (const MapPair& pair : entity.pairs)
                if (std::find(kTargetKeys.begin(), kTargetKeys.end(), pair.key) != kTargetKeys.end())
                    targets_.insert(pair.value);
        }
    }

    void check() {
        for (const MapEntity& entity : entities_) check_entity(entity);
        const auto is_start = [](const MapEntity& entity) { return role_of(entity) == ClassRole::Start; };
        const auto first = std::find_if(entities_.begin(), entities_.end(), is_start);
        if (first == entities_.end())
            return warnings_.add(entities_.front().line,
                                 "no info_player_start, expected one: the player has no place to start");
        if (const auto second = std::find_if(first + 1, entities_.end(), is_start); second != entities_.end())
            warnings_.add(second->line, "a second info_player_start, expected one: that of line " +
                                            std::to_string(first->line) + " counts");
    }

  private:
    void name(const MapEntity& entity, const std::string& its_name) {
        if (!its_name.empty()) named_.emplace(its_name, &entity);
        // Chthon's electrodes are found by their target (Quake's e1m7).
        if (role_of(entity) == ClassRole::Lightning) named_.emplace("lightning", &entity);
    }

    void check_entity(const MapEntity& entity) {
        const std::string name = entity.value("classname");
        if (name.empty()) return warnings_.add(entity.line, "an entity without a classname, expected one");
        const EntityClass* const its_class = find_entity_class(name);
        if (its_class == nullptr || its_class->is_family()) {
            for (const MapPair& pair : entity.pairs)  // what is read of any class
                if (const EntityKey* const row = find_entity_key({}, pair.key)) check_numbers(pair, *row);
            const std::string_view reason = reason_left_out(name);
            return warnings_.add(entity.line,
                                 "the class " + as_quoted(name) +
                                     (reason.empty() ? " is unknown" + nearest_class(name)
                                                     : " is left out (" + std::string(reason) + ")") +
                                     ": the entity is kept unchanged",
                                 true);
        }
        check_shape(entity, *its_class, with_article(name));
        for (const auto& keys : its_class->keys)
            for (const EntityKey& row : keys)
                if (row.is_required && entity.value(row.name).empty())
                    warnings_.add(entity.line, with_article(name) + " without '" + std::string(row.name) +
                                                   "', expected " + std::string(row.does));
        for (const MapPair& pair : entity.pairs) {
            check_pair(pair, *its_class, name);
            const auto same = std::find_if(entity.pairs.begin(), entity.pairs.end(),
                                           [&](const MapPair& other) { return other.key == pair.key; });
            if (&*same != &pair)
                warnings_.add(pair.line, as_quoted(pair.key) + " is already set in line " + std::to_string(same->line) +
                                             ", expected each key once: that one counts");
        }
        for (const MapBrush& brush : entity.brushes) check_textures(brush, belongs_to_world(entity));
    }

    void check_axes(const MapSide& side) {
        if (!side.texture.has_axes) return;
        const auto& [u, v] = side.texture.axes;
        constexpr double kLeast = 1e-4;  // of 1, that of two axes in the face at right angles
        if (std::abs(dot(cross(u, v), plane_of(side).normal)) <= kLeast * length(u) * length(v))
            warnings_.add(side.line, "the texture axes of " + as_quoted(side.texture.name) +
                                         " are zero, parallel or lead off the face, expected two directions along it");
    }

    // The first side decides what a brush of the world holds; others are solid.
    void check_textures(const MapBrush& brush, bool is_of_world) {
        for (const MapSide& side : brush.sides) check_axes(side);
        if (brush.sides.empty() || !is_of_world) return;
        const std::string& first = brush.sides.front().texture.name;
        for (const MapSide& side : brush.sides) {
            const std::string& own = side.texture.name;
            if (contents_of_texture(own) == contents_of_texture(first) || is_undrawn_texture(own)) continue;
            return warnings_.add(side.line, "a brush with both " + as_quoted(first) + " and " + as_quoted(own) +
                                                " is made of the former, expected textures of one kind");
        }
    }

    void check_shape(const MapEntity& entity, const EntityClass& its_class, const std::string& name) {
        const bool is_layer = entity.has("_tb_type");  // TrenchBroom's: it may hold only point entities
        if (its_class.shape == ClassShape::Brush && entity.brushes.empty() && !is_layer)
            warnings_.add(entity.line, name + " without brushes, expected at least one: it has no shape");
        if (its_class.shape == ClassShape::Point && !entity.brushes.empty())
            warnings_.add(entity.line, name + " with brushes, expected an 'origin' alone: its class is a point");
        else if (its_class.shape == ClassShape::Point && entity.value("origin").empty())
            warnings_.add(entity.line, name + " without an 'origin', expected its position");
    }

    void check_pair(const MapPair& pair, const EntityClass& its_class, const std::string& class_name) {
        const EntityKey* const row = find_entity_key(its_class, pair.key);
        if (row == nullptr) {
            if (pair.key.starts_with("_tb_") || pair.key == "angle") return;  // editors give them to everything
            const std::string_view reason = reason_left_out(pair.key);
            if (!reason.empty() && pair.value == "0") return;  // asks for nothing
            warnings_.add(pair.line,
                          "nothing reads the key " + as_quoted(pair.key) + " of " + with_article(class_name) +
                              (reason.empty() ? nearest_key(its_class, pair.key) : ": " + std::string(reason)),
                          true);
        } else if (!row->does.empty() && check_numbers(pair, *row) && !pair.value.empty()) {
            check_value(pair, *row);
            const bool is_of_world = its_class.role == ClassRole::Worldspawn;
            if (is_of_world && expected_instead_of(pair.value, *row).empty()) check_effect(pair);
        }
    }

    // What the engine would say at each load.
    void check_effect(const MapPair& pair) {
        Level level;
        level.entities.push_back({{{"classname", "worldspawn"}, {pair.key, pair.value}}});
        for (const std::string& warning : read_level_effects(level).warnings) warnings_.add(pair.line, warning);
    }

    // Whether the value is of its kind; an empty text is, and an empty required value is missing.
    bool check_numbers(const MapPair& pair, const EntityKey& row) {
        const bool may_be_empty = row.kind == KeyKind::Text || row.kind >= KeyKind::Name || row.is_required;
        if (pair.value.empty() && (may_be_empty || row.name == "origin")) return true;
        std::string expected = expected_instead_of(pair.value, row);
        if (expected.empty()) return true;
        if (row.kind == KeyKind::Choice) expected += ": " + std::string(row.usual) + " is taken";
        warnings_.add(pair.line, as_quoted(pair.key) + " is " + as_quoted(pair.value) + ", expected " + expected);
        return false;
    }

    void check_value(const MapPair& pair, const EntityKey& row) {
        if (row.kind == KeyKind::Name && !targets_.contains(pair.value) && pair.value != kVisitName)
            warnings_.add(pair.line, as_quoted(pair.key) + " is " + as_quoted(pair.value) +
                                         ", but no entity has that target: nothing activates it");
        if (row.kind != KeyKind::Target && row.kind != KeyKind::Place) return;
        const auto target = named_.find(pair.value);
        if (target == named_.end())
            warnings_.add(pair.line,
                          as_quoted(pair.key) + " is " + as_quoted(pair.value) + ", but no entity has that name");
        else if (row.kind == KeyKind::Place && target->second->value("origin").empty())
            warnings_.add(pair.line, as_quoted(pair.key) + " is " + as_quoted(pair.value) +
                                         ", but the first entity of that name has no origin");
    }

    const std::vector<MapEntity>& entities_;
    Warnings& warnings_;
    std::unordered_map<std::string, const MapEntity*> named_;  // the first with a name
    std::unordered_set<std::string> targets_;
};

// The number of letters to change, add, remove or swap with the next one (Damerau, Levenshtein).
std::size_t typing_errors(std::string_view a, std::string_view b) {
    std::vector<std::size_t> before, last(b.size() + 1), now(b.size() + 1);
    for (std::size_t j = 0; j <= b.size(); ++j) last[j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        now[0] = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            now[j] = std::min({last[j] + 1, now[j - 1] + 1, last[j - 1] + (a[i - 1] != b[j - 1])});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                now[j] = std::min(now[j], before[j - 2] + 1);
        }
        before = std::exchange(last, now);
    }
    return last.back();
}

}  // namespace

void NearestName::add(std::string_view name) {
    constexpr std::size_t kLongest = 64;
    if (name.ends_with('#')) name.remove_suffix(1);
    if (name.ends_with('*') || wanted_.size() > kLongest) return;
    const std::size_t errors = typing_errors(wanted_, name);
    if (errors >= least_) return;
    least_ = errors;
    name_ = name;
}

std::string NearestName::text() const {
    return name_.empty() ? "" : ", perhaps '" + std::string(name_) + "' is meant";
}

void Warnings::add(int line, const std::string& what, bool is_unread) {
    if (known_[what]++ == 0) warnings_.push_back({line, what, is_unread});
}

std::vector<Warning> Warnings::take() {
    for (Warning& warning : warnings_) {
        const int others = known_[warning.what] - 1;
        if (others > 0) warning.what += " (and " + std::to_string(others) + " more like this)";
    }
    constexpr std::size_t kMost = 200;
    known_.clear();
    std::stable_sort(warnings_.begin(), warnings_.end(), [](const Warning& a, const Warning& b) {
        return std::pair(a.is_unread, a.line) < std::pair(b.is_unread, b.line);
    });
    if (warnings_.size() > kMost) {
        const std::size_t more = warnings_.size() - kMost;
        warnings_.resize(kMost + 1);
        warnings_.back().what = "this and " + std::to_string(more - 1) + " more warnings, which are not shown";
    }
    return std::exchange(warnings_, {});
}

void find_warnings(const std::vector<MapEntity>& entities, Warnings& warnings) {
    Checker(entities, warnings).check();
}

}  // namespace oblong::map
