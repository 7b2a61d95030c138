#include "game/program/title.h"

#include <filesystem>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/io/files.h"
#include "game/simulation/items.h"

namespace oblong {

Title::Title(std::shared_ptr<const LoadedLevel> loaded, const std::string& demo_file, Workers* workers,
             ViewOptions& view_options, Platform& platform)
    : loaded_(std::move(loaded)),
      settings_{workers, nullptr, SessionKind::Title},
      view_options_(view_options),
      platform_(platform) {
    if (std::filesystem::exists(demo_file)) demo_ = read_parsed(demo_file, decode_demo);
    begin();
}

// A demo of another level is ignored.
void Title::begin() {
    const GameState state = start_of(loaded_->level);
    if (demo_ && demo_->start_hash != start_hash_of(state, loaded_->data.rules_hash)) demo_.reset();
    walk_ = std::make_unique<Session>(loaded_, settings_, view_options_,
                                      TickInputSource(state, demo_, false, loaded_->data.rules_hash), platform_);
}

// Restarts the demo when it has ended, is about to show the end of the level, or deviates from its record.
void Title::advance_behind_menu(std::uint64_t now_us) {
    const ItemCount lenses = count_items(loaded_->level, walk_->state(), ItemClass::Lens);
    if (!walk_->input().is_replaying() || (lenses.all > 0 && lenses.taken == lenses.all)) {
        if (demo_) begin();
        return walk_->advance_behind_menu(now_us);
    }
    try {
        walk_->advance({}, now_us);
    } catch (const InputError&) {
        demo_.reset();
        begin();
    }
}

}  // namespace oblong
