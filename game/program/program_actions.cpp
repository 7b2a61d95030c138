// What the menu's pages ask of the program and have it do.
#include <exception>
#include <utility>

#include "game/program/program.h"

namespace oblong {

Goal Program::goal() const {
    return walk_ ? goal_of(walk_->loaded().level, walk_->state()) : Goal{};
}

void Program::try_with_files(const std::string& what, const std::function<void()>& work) {
    try {
        work();
    } catch (const std::exception& error) {
        pages_.open_message(what, error.what());
    }
}

std::shared_ptr<const LoadedLevel> Program::load_level(const std::string& file) const {
    return game_.load(file, screens_.front()->shared_level());
}

void Program::walk() {
    if (const auto first = std::move(first_walk_))
        return start(std::move(first->loaded), std::move(first->input),
                     options_.replay.empty() ? SessionKind::Walk : SessionKind::Replay);
    try_with_files("Walk", [&] { start_walk(load_level("")); });
}

void Program::play_level(const std::string& file) {
    try_with_files("Levels", [&] { leave_walk([this, loaded = load_level(file)] { start_walk(loaded); }); });
}

void Program::play_next() {
    try_with_files("Levels", [&] {
        start_walk(load_level(game_.find(game_.next_level(walk_->loaded(), walk_->state()), walk_->loaded())));
    });
}

void Program::restart() {
    leave_walk([this] { start_walk(walk_->shared_level()); });
}

void Program::show_gallery() {
    menu_.close_all();
    screens_.push_back(std::make_unique<Gallery>(screen().shared_level(), settings_, view_options_, platform_));
}

void Program::show_title() {
    leave_walk([this] { try_with_files("Title", [this] { start_title(load_level("")); }); });
}

void Program::leave() {
    leave_walk([this] { has_left_ = true; });
}

void Program::keep_recorded() {
    if (walk_ && walk_->input().records() && !recorded_) recorded_ = std::make_unique<Demo>(walk_->input().recorded());
}

}  // namespace oblong
