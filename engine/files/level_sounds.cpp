
#include <filesystem>
#include <map>

#include "engine/base/table.h"
#include "engine/effects/entity_values.h"
#include "engine/files/files.h"
#include "engine/files/sound_file.h"
#include "engine/level/entity_classes.h"

namespace oblong {
namespace {

namespace fs = std::filesystem;

constexpr const char* kKey = "noise";

std::string find_in(const std::vector<std::string>& folders, const std::string& name) {
    std::error_code ignored;
    for (const fs::path folder : folders)
        if (fs::is_regular_file(folder / name, ignored)) return (folder / name).lexically_normal().string();
    return {};
}

}  // namespace

LevelSounds read_level_sounds(const Level& level, const std::vector<std::string>& folders) {
    LevelSounds read;
    read.by_entity.resize(level.entities.size(), LevelSounds::kNone);
    std::map<std::string, std::int32_t> known;
    for (std::size_t i = 0; i < level.entities.size(); ++i) {
        const Entity& entity = level.entities[i];
        const std::string name = entity.value(kKey);
        if (name.empty()) continue;
        const EntityClass* const its_class = find_entity_class(entity.value("classname"));
        if (!its_class || !find_entity_key(*its_class, kKey)) continue;
        const auto [at, is_new] = known.try_emplace(name, LevelSounds::kNone);
        if (is_new) {
            const EntityValues values(entity, i, read.warnings);
            const std::string file = stays_below(name) ? find_in(folders, name) : "";
            if (!stays_below(name))
                values.warn("noise is \"" + name + "\", expected a path of a file below the game's folder");
            else if (file.empty())
                values.warn("there is no file " + name + " for its noise, expected one in " + folders.front());
            else {
                read.sounds.push_back({name, file, read_parsed(file, decode_sound)});
                at->second = static_cast<std::int32_t>(read.sounds.size()) - 1;
            }
        }
        read.by_entity[i] = at->second;
    }
    return read;
}

}  // namespace oblong
