#include "game/gallery.h"

#include <algorithm>
#include <array>
#include <utility>

#include "game/screenshot.h"
#include "tools/gallery/rows.h"

namespace oblong {

namespace {

constexpr std::array<std::string_view, 9> kGalleryHelp{
    "Page Down, Page Up  next row, row before",
    "Up, Down            choose a parameter",
    "Left, Right         change it",
    "F6                  all figures and notes",
    "F2, F3              aspect",
    "F4                  accuracy",
    "F5, C               scaling, tube",
    "F12                 screenshots",
    "F1                  this help",
};

/// What is changed by the same keys as in the game.
constexpr std::array<Command, 8> kKeysOfTheGame{
    Command::ProjectionAspect, Command::DisplayAspect, Command::AccuracyTier, Command::ScalingMode,
    Command::CrtLook,          Command::Darker,        Command::Brighter,     Command::ShowHelp};

void go_to_row(std::size_t row, GalleryState& state) {
    state.row = row;
    state.chosen = 0;
}

void change_parameter(const Row& row, std::int64_t steps, GalleryState& state) {
    if (row.parameters.empty()) return;
    const Parameter& parameter = row.parameters[state.chosen];
    std::int64_t& value = state.values[state.row][state.chosen];
    const std::int64_t count = parameter.most - parameter.least + 1;
    if (parameter.choices.empty())
        value = std::clamp(value + steps * parameter.step, parameter.least, parameter.most);
    else
        value = (value + steps + count) % count;
}

std::string list_of_figures(const Row& row, const RowPage& page) {
    std::string text = std::string(row.seeds) + "\n" + std::string(row.source) + "\n" + std::string(row.test) + "\n";
    for (const Figure& figure : page.figures) text += "\n" + figure_text(figure);
    for (const std::string& note : page.notes) text += "\n\n" + note;
    return text;
}

}  // namespace

GalleryState start_of_gallery(const std::vector<Row>& rows) {
    GalleryState state;
    for (const Row& row : rows) state.values.push_back(start_values(row));
    return state;
}

std::string apply(Command command, const std::vector<Row>& rows, const ScreenMode& mode, WindowSize window,
                  ViewOptions& view_options, GalleryState& state) {
    const Row& row = rows[state.row];
    const std::size_t count = rows.size(), parameters = std::max<std::size_t>(row.parameters.size(), 1);
    switch (command) {
        case Command::PageDown:
            go_to_row((state.row + 1) % count, state);
            return "";
        case Command::PageUp:
            go_to_row((state.row + count - 1) % count, state);
            return "";
        case Command::DialUp:
            state.chosen = (state.chosen + parameters - 1) % parameters;
            return "";
        case Command::DialDown:
            state.chosen = (state.chosen + 1) % parameters;
            return "";
        case Command::DialCoarser:
        case Command::DialFiner:
            change_parameter(row, command == Command::DialFiner ? 1 : -1, state);
            return "";
        case Command::FrameCost:
            state.lists_figures = !state.lists_figures;
            return "";
        default:
            break;
    }
    const bool is_of_game = std::find(kKeysOfTheGame.begin(), kKeysOfTheGame.end(), command) != kKeysOfTheGame.end();
    return is_of_game ? apply(command, view_options, mode, window) : "";
}

Gallery::Gallery(std::shared_ptr<const LoadedLevel> loaded, const SessionSettings& settings, ViewOptions& view_options,
                 Platform& platform)
    : loaded_(std::move(loaded)),
      data_(loaded_->data),
      assets_{data_.level, data_.colormap, text_colours_of(data_.palette)},
      rows_(gallery_rows()),
      mode_(settings.mode),
      screenshot_folder_(settings.screenshot_folder),
      platform_(platform),
      view_options_(view_options),
      state_(start_of_gallery(rows_)),
      picture_(pixel_count(mode_.width_px, mode_.height_px)),
      start_us_(platform.now_us()),
      now_us_(start_us_) {
    show_message(hud_, "Page Down: next row    F1 Help", start_us_);
}

void Gallery::advance(const Controls& controls, std::uint64_t now_us) {
    now_us_ = now_us;
    for (const Command command : controls.commands) {
        wants_screenshot_ |= command == Command::Screenshot;
        const std::string message = apply(command, rows_, mode_, platform_.window_size(), view_options_, state_);
        if (!message.empty()) show_message(hud_, message, now_us);
    }
    if (!controls.commands.empty() || rows_[state_.row].moves) is_drawn_ = false;
}

ShownPicture Gallery::draw() {
    if (!is_drawn_) draw_picture();
    shown_ = picture_;
    const Framebuffer canvas{shown_.data(), mode_.width_px, mode_.height_px, mode_.width_px};
    if (wants_screenshot_)
        show_message(hud_, save_screenshots(screenshot_folder_, canvas, data_.palette, mode_), now_us_);
    wants_screenshot_ = false;
    draw_over();
    PresentRect rect = layout(platform_.window_size(), mode_, view_options_.shown_as, view_options_.scaling);
    rect.has_crt_look = view_options_.has_crt_look;
    return {canvas, data_.palette, rect};
}

void Gallery::draw_picture() {
    const Row& row = rows_[state_.row];
    const auto time_ms = static_cast<std::int64_t>((now_us_ - start_us_) / 1000);
    const RowInput input{assets_, mode_, settings_of(view_options_), state_.values[state_.row], time_ms};
    page_ = draw_row(row, input, state_.chosen, {picture_.data(), mode_.width_px, mode_.height_px, mode_.width_px});
    const std::string number = std::to_string(state_.row + 1) + " of " + std::to_string(rows_.size());
    platform_.set_title(("Oblong - the gallery, " + number + ": " + std::string(row.name)).c_str());
    is_drawn_ = true;
}

void Gallery::draw_over() {
    const Framebuffer canvas{shown_.data(), mode_.width_px, mode_.height_px, mode_.width_px};
    if (state_.lists_figures) {
        const std::string text = list_of_figures(rows_[state_.row], page_);
        draw_panel(canvas, lines_of(text, mode_.width_px - 4 * kTextMargin_px), assets_.text);
    }
    if (view_options_.shows_help) draw_panel(canvas, kGalleryHelp, assets_.text);
    if (now_us_ < hud_.message_ends_us) draw_lines(kHeader_px + kTextMargin_px, hud_.message, assets_.text, canvas);
}

}  // namespace oblong
