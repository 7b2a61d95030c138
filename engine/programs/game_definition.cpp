#include "engine/programs/game_definition.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <optional>
#include <unordered_set>

#include "engine/base/checksum.h"
#include "engine/base/input_error.h"
#include "engine/io/files.h"
#include "engine/level/entity_classes.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

/// The members of an object in the file's order. nlohmann's own keep one of two of a name, and look through all for
/// each.
template <class Name, class Type, class, class Allocator>
struct Members : nlohmann::ordered_map<Name, Type, std::less<>, Allocator> {
    Type& operator[](const Name& name) {
        if (!names.insert(name).second)
            throw InputError("member \"" + name + "\"", "is there twice, expected each once");
        this->std::vector<std::pair<const Name, Type>, Allocator>::emplace_back(name, Type{});
        return this->back().second;
    }
    std::unordered_set<Name> names;
};
using Json = nlohmann::basic_json<Members>;

/// A value in the file, and its path, as "/classes/item_coin/is".
class Value {
  public:
    Value(const Json& json, std::string where) : json_(json), where_(std::move(where)) {}

    [[noreturn]] void refuse(const std::string& what) const { throw InputError(where_.empty() ? "/" : where_, what); }
    std::string text() const {
        if (!json_.is_string()) refuse("is " + std::string(json_.type_name()) + ", expected a text");
        return json_.get<std::string>();
    }
    /// use(name, value) for each member.
    template <class Use>
    void for_members(Use use) const {
        if (!json_.is_object()) refuse("is " + std::string(json_.type_name()) + ", expected members in { }");
        for (const auto& [name, json] : json_.items()) use(name, Value(json, where_ + "/" + name));
    }
    std::vector<Value> elements() const {
        if (!json_.is_array()) refuse("is " + std::string(json_.type_name()) + ", expected a list in [ ]");
        std::vector<Value> values;
        for (std::size_t i = 0; i < json_.size(); ++i) values.emplace_back(json_[i], where_ + "/" + std::to_string(i));
        return values;
    }

  private:
    const Json& json_;
    std::string where_;
};

// Roles that oblong-map recognises by the class's name, so that own classes cannot have them.
bool is_of_compiler(ClassRole role) {
    constexpr std::array kOfCompiler{ClassRole::Worldspawn,     ClassRole::Start,      ClassRole::TeleportExit,
                                     ClassRole::Lamp,           ClassRole::BrushGroup, ClassRole::Detail,
                                     ClassRole::PassableDetail, ClassRole::Lightning};
    return std::find(kOfCompiler.begin(), kOfCompiler.end(), role) != kOfCompiler.end();
}

// The row of a class, but not of a family of classes.
const EntityClass* find_own_row(const std::string& name) {
    const EntityClass* const row = find_entity_class(name);
    return row && !row->is_family() ? row : nullptr;
}

class DefinitionReader {
  public:
    explicit DefinitionReader(const std::string& folder) {
        game_.folder = folder;
        game_.has_gallery = game_.has_lab = false;
    }

    GameDefinition read(const Value& root) {
        root.for_members([this](const std::string& name, const Value& value) { read_member(name, value); });
        if (game_.title.empty()) root.refuse("has no \"title\", expected one");
        if (game_.levels.empty()) root.refuse("has no \"levels\", expected a list of one or more names");
        game_.rules_hash = hash_of_classes();
        return std::move(game_);
    }

  private:
    void read_member(const std::string& name, const Value& value) {
        for (const Member& member : kMembers)
            if (name == member.known.name) return (this->*member.read)(value);
        std::string names;
        for (const Member& member : kMembers) names += (names.empty() ? "" : ", ") + std::string(member.known.name);
        value.refuse("is unknown, expected one of " + names);
    }
    void read_title(const Value& value) { game_.title = value.text(); }
    void read_credits(const Value& value) { game_.credits = value.text(); }
    void read_palette(const Value& value) { game_.palette = file_in_folder(value); }
    void read_music(const Value& value) { game_.music = file_in_folder(value); }
    void read_icon(const Value& value) { game_.icon = file_in_folder(value); }
    void read_demo(const Value& value) { game_.demo = path_in_folder(value); }

    std::string path_in_folder(const Value& value) const {
        const std::string path = value.text();
        if (leads_out(game_.folder, path)) value.refuse("\"" + path + "\", expected a path of a file below the folder");
        return (fs::path(game_.folder) / path).string();
    }
    std::string file_in_folder(const Value& value) const {
        const std::string path = path_in_folder(value);
        if (!fs::is_regular_file(path)) value.refuse("there is no file " + path + ", expected one");
        return path;
    }

    void read_levels(const Value& list) {
        std::unordered_set<std::string> names;
        for (const Value& value : list.elements()) {
            const std::string name = value.text();
            if (!stays_below(name) || fs::path(name).has_parent_path() || name != printable(name))
                value.refuse("\"" + name + "\", expected the name of a level, as \"first\"");
            if (!names.insert(name).second) value.refuse("\"" + name + "\" is there twice, expected each level once");
            game_.levels.push_back(name);
        }
    }

    void read_shows(const Value& list) {
        for (const Value& value : list.elements()) {
            const std::string name = value.text();
            const std::map<std::string, bool*> parts{
                {"counts", &game_.has_counts}, {"gallery", &game_.has_gallery}, {"lab", &game_.has_lab}};
            const auto part = parts.find(name);
            if (part == parts.end()) value.refuse("\"" + name + "\", expected counts, gallery or lab");
            *part->second = true;
        }
    }

    void read_captions(const Value& members) {
        members.for_members(
            [this](const std::string& sound, const Value& value) { game_.captions[sound] = value.text(); });
    }

    void read_classes(const Value& members) {
        members.for_members([this](const std::string& name, const Value& value) {
            if (find_own_row(name)) value.refuse("is a class of the engine, expected another name");
            game_.classes[name] = class_of(value);
        });
    }

    static OwnClass class_of(const Value& value) {
        OwnClass own;
        const EntityClass* base = nullptr;
        std::optional<Value> keys;
        value.for_members([&](const std::string& member, const Value& part) {
            if (member == "is") {
                own.is = part.text();
                base = find_own_row(own.is);
                if (!base) part.refuse("\"" + own.is + "\", expected a class of the engine");
            } else if (member == "keys") {
                keys.emplace(part);
            } else if (member == "does") {
                own.does = part.text();
            } else {
                part.refuse("is unknown, expected is, keys or does");
            }
        });
        if (base && is_of_compiler(base->role))
            value.refuse("stands for " + own.is + ", which the map compiler has to know by its name, expected another");
        if (!base) value.refuse("has no \"is\", expected a class of the engine that it stands for");
        if (keys)
            keys->for_members([&](const std::string& key, const Value& text) {
                own.values.emplace_back(key, checked_text(text, find_entity_key(*base, key), own.is));
            });
        return own;
    }

    static std::string checked_text(const Value& value, const EntityKey* key, const std::string& its_class) {
        if (!key) value.refuse("is unknown, expected a key of " + its_class);
        const std::string text = value.text(), expected = expected_instead_of(text, *key);
        if (!expected.empty()) value.refuse("\"" + text + "\", expected " + expected);
        return text;
    }

    std::uint64_t hash_of_classes() const {
        if (game_.classes.empty()) return 0;
        Fnv1a hash;
        const auto add = [&](const std::string& text) {
            for (const char letter : text) hash.add(static_cast<std::uint8_t>(letter));
            hash.add(std::uint8_t{0});
        };
        for (const auto& [name, own] : game_.classes) {
            add(name);
            add(own.is);
            for (const auto& [key, value] : own.values) {
                add(key);
                add(value);
            }
        }
        return hash.value();
    }

    struct Member {
        GameMember known;
        void (DefinitionReader::*read)(const Value&);
    };
    static const std::array<Member, 10> kMembers;
    friend std::vector<GameMember> oblong::game_members();

    GameDefinition game_;
};

const std::array<DefinitionReader::Member, 10> DefinitionReader::kMembers{{
    {{"title", "the game's name; required. As all texts in UTF-8, whose Latin letters are drawn"},
     &DefinitionReader::read_title},
    {{"levels", "the names of its levels in their order, `first` is `maps/first.bsp`; required"},
     &DefinitionReader::read_levels},
    {{"palette", "a file of 768 bytes; without: the museum's"}, &DefinitionReader::read_palette},
    {{"music", "the title's: a tracker module (MOD)"}, &DefinitionReader::read_music},
    {{"demo", "the title's: a walk that `--record` wrote"}, &DefinitionReader::read_demo},
    {{"icon", "the window's: a picture (PNG, TGA, JPEG, BMP) of up to 256x256 pixels"}, &DefinitionReader::read_icon},
    {{"captions",
      "other words: for sounds, by the names of the museum's files or the path of a `noise`; for `a lens`, `lenses`, "
      "`You need the silver key`, `You have the gold key`, `You receive 25 health` and their like, `You did not "
      "survive.` and `You have reached the end.`"},
     &DefinitionReader::read_captions},
    {{"classes",
      "of entities, by their names: `is`, a class of the engine, and `keys`, their values where an entity "
      "has none; `does` is for readers"},
     &DefinitionReader::read_classes},
    {{"shows", "a list of what else it has: `gallery`, `lab` of the museum, `counts`, a line with what was taken"},
     &DefinitionReader::read_shows},
    {{"credits", "what the page of credits says first"}, &DefinitionReader::read_credits},
}};

// From the parser's "[json.exception.parse_error.101] parse error at line 3, column 8: syntax error while ...".
InputError syntax_error(const std::string& said) {
    const std::size_t place = std::min(said.find("line "), said.size()), end = said.find(": ", place);
    if (end == said.npos) return InputError("JSON", said);
    return InputError(said.substr(place, end - place), "no JSON: " + said.substr(end + 2));
}

}  // namespace

std::vector<GameMember> game_members() {
    std::vector<GameMember> members;
    for (const DefinitionReader::Member& member : DefinitionReader::kMembers) members.push_back(member.known);
    return members;
}

GameDefinition read_game_definition(const std::string& folder) {
    const std::string file = (fs::path(folder) / kGameFile).string(), text = read_text(file);
    return naming_file(file, [&] {
        try {
            return DefinitionReader(folder).read(Value(Json::parse(text), ""));
        } catch (const Json::parse_error& error) {
            throw syntax_error(error.what());
        } catch (const Json::out_of_range& error) {
            throw InputError("JSON", std::string(error.what()) + ", expected a smaller number");
        }
    });
}

}  // namespace oblong
