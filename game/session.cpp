#include "game/session.h"

#include <filesystem>

#include "game/screenshot.h"

namespace oblong {
namespace {

constexpr std::uint64_t kCostEvery_us = 500'000;

}  // namespace

Session::Session(const GameData& data, const Stage& stage, const SessionSettings& settings, Hands& hands,
                 Platform& platform)
    : data_(data),
      stage_(stage),
      hands_(hands),
      platform_(platform),
      choices_(settings.choices),
      field_of_view_(settings.field_of_view),
      screenshot_folder_(settings.screenshot_folder),
      painter_(data, stage, settings.mode),
      inks_(inks_of(data.palette)),
      before_(start_of(stage)),
      after_(before_) {
    hud_.end_message = stage.end_message;
}

void Session::run() {
    platform_.set_title(("Oblong - " + std::filesystem::path(data_.level_file).stem().string()).c_str());
    last_us_ = cost_since_us_ = platform_.now_us();
    tell(hud_, "F1 Help", last_us_);
    while (platform_.is_open()) play_frame();
}

void Session::play_frame() {
    const Controls controls = platform_.poll();
    const std::uint64_t now_us = platform_.now_us();
    hands_.gather(controls);
    obey(controls, now_us);
    advance(now_us);
    draw(now_us);
}

void Session::obey(const Controls& controls, std::uint64_t now_us) {
    for (const Command command : controls.commands) {
        wants_screenshot_ |= command == Command::Screenshot;
        const std::string told = apply(command, choices_, painter_.mode(), platform_.window_size());
        if (!told.empty()) tell(hud_, told, now_us);
    }
}

void Session::advance(std::uint64_t now_us) {
    for (int due = clock_.advance(now_us - last_us_); due > 0; --due) {
        before_ = after_;
        hands_.play_tick(stage_, after_);
    }
    last_us_ = now_us;
}

void Session::draw(std::uint64_t now_us) {
    const std::int32_t fraction = clock_.fraction_16();
    const Moment moment{before_, after_, fraction};
    const std::uint64_t began_us = platform_.now_us();
    painter_.draw(moment, camera_at(moment, hands_.lead(fraction), field_of_view_), settings_of(choices_));
    note_cost(began_us, platform_.now_us());

    const Framebuffer canvas = painter_.canvas();
    if (wants_screenshot_)
        tell(hud_, save_screenshots(screenshot_folder_, canvas, data_.palette, painter_.mode()), now_us);
    wants_screenshot_ = false;
    hud_.shows_help = choices_.shows_help;
    hud_.shows_end = after_.has_ended;
    draw_hud(hud_, now_us, inks_, canvas);
    platform_.present(canvas, data_.palette,
                      layout(platform_.window_size(), painter_.mode(), choices_.shown_as, choices_.scaling));
}

void Session::note_cost(std::uint64_t began_us, std::uint64_t ended_us) {
    if (!choices_.shows_cost) hud_.cost.clear();
    drawing_us_ += ended_us - began_us;
    ++frames_since_;
    const std::uint64_t since_us = ended_us - cost_since_us_;
    if (since_us < kCostEvery_us) return;
    if (choices_.shows_cost)
        hud_.cost = std::to_string(drawing_us_ / frames_since_) + " us a frame, " +
                    std::to_string(frames_since_ * 1'000'000 / since_us) + " frames a second";
    cost_since_us_ = ended_us;
    drawing_us_ = frames_since_ = 0;
}

}  // namespace oblong
