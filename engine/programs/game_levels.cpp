#include <algorithm>
#include <array>
#include <filesystem>

#include "engine/io/files.h"
#include "engine/programs/game_definition.h"

namespace oblong {

namespace fs = std::filesystem;

bool is_replaceable(const std::string& words) {
    constexpr std::array<std::string_view, 4> kWords{kOneLens, kLenses, kReachedEnd, "You did not survive."};
    constexpr std::array<std::string_view, 3> kBeginnings{kYouNeed, "You have the ", "You receive "};
    return std::find(kWords.begin(), kWords.end(), words) != kWords.end() ||
           std::any_of(kBeginnings.begin(), kBeginnings.end(),
                       [&](std::string_view beginning) { return words.starts_with(beginning); });
}

std::string own_words(const GameDefinition& game, const std::string& words) {
    const auto own = game.captions.find(words);
    return own == game.captions.end() ? words : own->second;
}

bool is_game_folder(const std::string& folder) {
    std::error_code ignored;
    return !folder.empty() && fs::is_regular_file(fs::path(folder) / kGameFile, ignored);
}

std::string level_file_of(const GameDefinition& game, const std::string& level) {
    const fs::path name = level + ".bsp", in_maps = game.folder / ("maps" / name), beside = game.folder / name;
    std::error_code ignored;
    const bool is_beside = !fs::is_regular_file(in_maps, ignored) && fs::is_regular_file(beside, ignored);
    return (is_beside ? beside : in_maps).string();
}

std::string level_after(const GameDefinition& game, const std::string& file) {
    std::error_code ignored;
    for (std::size_t i = 0; i + 1 < game.levels.size(); ++i)
        if (fs::equivalent(level_file_of(game, game.levels[i]), file, ignored)) return game.levels[i + 1];
    return {};
}

void apply_classes(const GameDefinition& game, std::vector<Entity>& entities) {
    for (Entity& entity : entities) {
        const auto own = game.classes.find(entity.value("classname"));
        if (own == game.classes.end()) continue;
        for (auto& [key, value] : entity.pairs)
            if (key == "classname") value = own->second.is;
        for (const auto& own_pair : own->second.values)
            if (std::none_of(entity.pairs.begin(), entity.pairs.end(),
                             [&](const auto& pair) { return pair.first == own_pair.first; }))
                entity.pairs.push_back(own_pair);
    }
}

}  // namespace oblong
