// What the title shows behind its menu: the recorded walk through the demo level until it has found what there is to
// find, again and again.
#include <filesystem>
#include <utility>

#include "engine/files/files.h"
#include "game/program/program.h"
#include "game/simulation/items.h"

namespace oblong {

namespace fs = std::filesystem;

void Program::start_title(std::shared_ptr<const LoadedLevel> loaded) {
    const fs::path file = fs::path(assets_folder_) / "walk.demo";
    title_demo_.reset();
    if (fs::exists(file)) title_demo_ = read_parsed(file.string(), decode_demo);
    title_options_.preferences = view_options_.preferences;
    TickInputSource input = title_input(loaded->level);
    start(std::move(loaded), std::move(input), Stage::Title);
    last_walk_ = has_saves() ? slots_.last_walk() : std::nullopt;
    pages_.open_title();
    if (!options_.folders.config_file.empty() && !view_options_.preferences.has_set_light) pages_.open_light();
}

// A demo of another level than the one that is there is left out.
TickInputSource Program::title_input(const GameLevel& level) {
    const GameState state = start_of(level);
    if (title_demo_ && title_demo_->start_hash != hash_of(state)) title_demo_.reset();
    return TickInputSource(state, title_demo_, false);
}

// The demo again when it has ended, is about to show how the level ends, or leads elsewhere than when it was recorded.
void Program::play_title() {
    const std::uint64_t now_us = platform_.now_us();
    const ItemCount lenses = count_items(session_->loaded().level, session_->state(), ItemClass::Lens);
    if (!session_->input().is_replaying() || (lenses.all > 0 && lenses.taken == lenses.all)) {
        if (title_demo_) start(session_->shared_level(), title_input(session_->loaded().level), Stage::Title);
        return session_->pause(now_us);
    }
    try {
        session_->advance({}, now_us);
    } catch (const InputError&) {
        title_demo_.reset();
        start(session_->shared_level(), title_input(session_->loaded().level), Stage::Title);
    }
}

}  // namespace oblong
