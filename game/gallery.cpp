#include "game/gallery.h"

#include <algorithm>
#include <array>

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

GalleryState start_of_gallery(const std::vector<Row>& rows, const ViewOptions& view_options) {
    GalleryState state;
    state.view_options = view_options;
    for (const Row& row : rows) state.values.push_back(start_values(row));
    return state;
}

std::string apply(Command command, const std::vector<Row>& rows, const ScreenMode& mode, WindowSize window,
                  GalleryState& state) {
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
    return is_of_game ? apply(command, state.view_options, mode, window) : "";
}

Gallery::Gallery(const GameData& data, const SessionSettings& settings, Platform& platform)
    : data_(data),
      assets_{data.level, data.colormap, text_colours_of(data.palette)},
      rows_(gallery_rows()),
      mode_(settings.mode),
      screenshot_folder_(settings.screenshot_folder),
      platform_(platform),
      state_(start_of_gallery(rows_, settings.view_options)),
      picture_(pixel_count(mode_.width_px, mode_.height_px)) {}

void Gallery::run() {
    start_us_ = platform_.now_us();
    show_message(hud_, "Page Down: next row    F1 Help", start_us_);
    while (platform_.is_open()) show_frame();
}

void Gallery::show_frame() {
    const Controls controls = platform_.poll();
    const std::uint64_t now_us = platform_.now_us();
    bool wants_screenshot = false;
    for (const Command command : controls.commands) {
        wants_screenshot |= command == Command::Screenshot;
        const std::string message = apply(command, rows_, mode_, platform_.window_size(), state_);
        if (!message.empty()) show_message(hud_, message, now_us);
    }
    if (!controls.commands.empty() || rows_[state_.row].moves) is_drawn_ = false;
    if (!is_drawn_) draw_picture();
    shown_ = picture_;
    const Framebuffer canvas{shown_.data(), mode_.width_px, mode_.height_px, mode_.width_px};
    if (wants_screenshot)
        show_message(hud_, save_screenshots(screenshot_folder_, canvas, data_.palette, mode_), now_us);
    draw_over(now_us);
    const ViewOptions& options = state_.view_options;
    PresentRect rect = layout(platform_.window_size(), mode_, options.shown_as, options.scaling);
    rect.has_crt_look = options.has_crt_look;
    platform_.present(canvas, data_.palette, rect);
}

void Gallery::draw_picture() {
    const Row& row = rows_[state_.row];
    const auto time_ms = static_cast<std::int64_t>((platform_.now_us() - start_us_) / 1000);
    const RowInput input{assets_, mode_, settings_of(state_.view_options), state_.values[state_.row], time_ms};
    page_ = draw_row(row, input, state_.chosen, {picture_.data(), mode_.width_px, mode_.height_px, mode_.width_px});
    const std::string number = std::to_string(state_.row + 1) + " of " + std::to_string(rows_.size());
    platform_.set_title(("Oblong - the gallery, " + number + ": " + std::string(row.name)).c_str());
    is_drawn_ = true;
}

void Gallery::draw_over(std::uint64_t now_us) {
    const Framebuffer canvas{shown_.data(), mode_.width_px, mode_.height_px, mode_.width_px};
    if (state_.lists_figures) {
        const std::string text = list_of_figures(rows_[state_.row], page_);
        draw_panel(canvas, lines_of(text, mode_.width_px - 4 * kTextMargin_px), assets_.text);
    }
    if (state_.view_options.shows_help) draw_panel(canvas, kGalleryHelp, assets_.text);
    if (now_us < hud_.message_ends_us) draw_lines(kHeader_px + kTextMargin_px, hud_.message, assets_.text, canvas);
}

}  // namespace oblong
