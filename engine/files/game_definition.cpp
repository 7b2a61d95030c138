#include "engine/files/game_definition.h"

#include <algorithm>
#include <array>
#include <filesystem>

#include "engine/base/checksum.h"
#include "engine/files/files.h"
#include "engine/files/json.h"
#include "engine/level/entity_classes.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;
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
    explicit DefinitionReader(const std::string& folder) { game_.folder = folder; }

    GameDefinition read(const JsonValue& root) {
        for (const auto& [name, value] : root.members()) read_member(name, value);
        if (game_.title.empty()) root.refuse("has no \"title\", expected one");
        if (game_.levels.empty()) root.refuse("has no \"levels\", expected a list of one or more names");
        game_.rules_hash = hash_of_classes();
        return std::move(game_);
    }

  private:
    void read_member(const std::string& name, const JsonValue& value) {
        for (const Member& member : kMembers)
            if (name == member.known.name) return (this->*member.read)(value);
        std::string names;
        for (const Member& member : kMembers) names += (names.empty() ? "" : ", ") + std::string(member.known.name);
        value.refuse("is unknown, expected one of " + names);
    }
    void read_title(const JsonValue& value) { game_.title = value.text(); }
    void read_credits(const JsonValue& value) { game_.credits = value.text(); }
    void read_palette(const JsonValue& value) { game_.palette = file_in_folder(value); }
    void read_music(const JsonValue& value) { game_.music = file_in_folder(value); }
    void read_icon(const JsonValue& value) { game_.icon = file_in_folder(value); }
    void read_demo(const JsonValue& value) { game_.demo = path_in_folder(value); }

    std::string path_in_folder(const JsonValue& value) const {
        const std::string path = value.text();
        if (!stays_below(path)) value.refuse("\"" + path + "\", expected a path of a file below the folder");
        return (fs::path(game_.folder) / path).string();
    }
    std::string file_in_folder(const JsonValue& value) const {
        const std::string path = path_in_folder(value);
        if (!fs::is_regular_file(path)) value.refuse("there is no file " + path + ", expected one");
        return path;
    }

    void read_levels(const JsonValue& list) {
        for (const auto& [index, value] : list.elements()) {
            const std::string name = value.text();
            if (!stays_below(name) || fs::path(name).has_parent_path())
                value.refuse("\"" + name + "\", expected the name of a level, as \"first\"");
            if (std::find(game_.levels.begin(), game_.levels.end(), name) != game_.levels.end())
                value.refuse("\"" + name + "\" is there twice, expected each level once");
            game_.levels.push_back(name);
        }
    }

    void read_captions(const JsonValue& members) {
        for (const auto& [sound, value] : members.members()) game_.captions[sound] = value.text();
    }

    void read_classes(const JsonValue& members) {
        for (const auto& [name, value] : members.members()) {
            if (find_own_row(name)) value.refuse("is a class of the engine, expected another name");
            game_.classes[name] = class_of(value);
        }
    }

    static OwnClass class_of(const JsonValue& value) {
        OwnClass own;
        const EntityClass* base = nullptr;
        for (const auto& [member, part] : value.members()) {
            if (member == "is") {
                own.is = part.text();
                base = find_own_row(own.is);
                if (!base) part.refuse("\"" + own.is + "\", expected a class of the engine");
            } else if (member == "keys") {
                for (const auto& [key, text] : part.members()) own.values.emplace_back(key, text.text());
            } else if (member != "does") {
                part.refuse("is unknown, expected is, keys or does");
            }
        }
        if (base && is_of_compiler(base->role))
            value.refuse("stands for " + own.is + ", which the map compiler has to know by its name, expected another");
        if (!base) value.refuse("has no \"is\", expected a class of the engine that it stands for");
        for (const auto& [key, text] : own.values)
            if (!find_entity_key(*base, key)) value.refuse("key \"" + key + "\", expected one of " + own.is);
        return own;
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
        void (DefinitionReader::*read)(const JsonValue&);
    };
    static const std::array<Member, 9> kMembers;
    friend std::vector<GameMember> oblong::game_members();

    GameDefinition game_;
};

const std::array<DefinitionReader::Member, 9> DefinitionReader::kMembers{{
    {{"title", "the game's name; required"}, &DefinitionReader::read_title},
    {{"levels", "the names of its levels in their order, `first` is `maps/first.bsp`; required"},
     &DefinitionReader::read_levels},
    {{"palette", "a file of 768 bytes; without: the museum's"}, &DefinitionReader::read_palette},
    {{"music", "the title's: a tracker module (MOD)"}, &DefinitionReader::read_music},
    {{"demo", "the title's: a walk that `--record` wrote"}, &DefinitionReader::read_demo},
    {{"icon", "the window's: a picture (PNG, TGA, JPEG, BMP) of up to 256x256 pixels"}, &DefinitionReader::read_icon},
    {{"captions",
      "other words for sounds, by the names of the museum's files or the path of a `noise`, and for `a lens` and "
      "`lenses`"},
     &DefinitionReader::read_captions},
    {{"classes",
      "of entities, by their names: `is`, a class of the engine, and `keys`, their values where an entity "
      "has none; `does` is for readers"},
     &DefinitionReader::read_classes},
    {{"credits", "what the page of credits says first"}, &DefinitionReader::read_credits},
}};

}  // namespace

std::vector<GameMember> game_members() {
    std::vector<GameMember> members;
    for (const DefinitionReader::Member& member : DefinitionReader::kMembers) members.push_back(member.known);
    return members;
}

GameDefinition read_game_definition(const std::string& folder) {
    const std::string file = (fs::path(folder) / kGameFile).string();
    return DefinitionReader(folder).read(parse_json(file, read_text(file)));
}

}  // namespace oblong
