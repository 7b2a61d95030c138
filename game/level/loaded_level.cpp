#include <algorithm>
#include <filesystem>
#include <string_view>

#include "engine/io/files.h"
#include "engine/level/entities.h"
#include "game/level/load.h"

namespace oblong {
namespace {

// Three numbers a line.
std::vector<Position> leak_path_beside(const std::string& level_file) {
    std::vector<Position> points;
    const std::string file = std::filesystem::path(level_file).replace_extension(".pts").string();
    std::error_code ignored;
    if (!std::filesystem::is_regular_file(file, ignored)) return points;
    const std::string text = read_text(file);
    for (std::string_view rest = text; !rest.empty();) {
        const std::string_view line = rest.substr(0, rest.find('\n'));
        rest.remove_prefix(std::min(line.size() + 1, rest.size()));
        if (const auto point = parse_world_vector(line)) points.push_back(*point);
    }
    return points;
}

// The game's own words for the museum's.
void put_words(const GameDefinition& game, GameLevel& level) {
    level.word_for_lens = own_words(game, kOneLens);
    level.word_for_lenses = own_words(game, kLenses);
    for (std::string& text : level.messages) {
        if (!is_replaceable(text)) continue;
        text = own_words(game, text);
        for (const std::string_view lens : {kOneLens, kLenses})
            if (text.starts_with(kYouNeed) && text.ends_with(lens))
                text.replace(text.size() - lens.size(), lens.size(), own_words(game, std::string(lens)));
    }
}

}  // namespace

LoadedLevel::LoadedLevel(const LevelFiles& named)
    : files(named),
      data(files.load(files)),
      level(naming_file(data.level_file,
                        [&] {
                            GameLevel made = make_game_level(data.level);
                            if (files.game) put_words(*files.game, made);
                            return made;
                        })),
      leak_path(leak_path_beside(data.level_file)) {}

}  // namespace oblong
