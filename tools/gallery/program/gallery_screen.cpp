#include "tools/gallery/program/gallery_screen.h"

#include <algorithm>
#include <array>
#include <new>
#include <utility>

#include "game/input/bindings.h"
#include "game/view/screenshot.h"
#include "tools/gallery/row.h"

namespace oblong {

namespace {

/// Keys that do the same as in the game.
constexpr std::array<Action, 7> kKeysOfTheGame{Action::ProjectionAspect, Action::DisplayAspect, Action::AccuracyTier,
                                               Action::ScalingMode,      Action::CrtLook,       Action::Darker,
                                               Action::Brighter};

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

}  // namespace

GalleryState start_of_gallery(const std::vector<Row>& rows) {
    GalleryState state;
    for (const Row& row : rows) state.values.push_back(start_values(row));
    return state;
}

std::string apply(Action command, const std::vector<Row>& rows, WindowSize window, ViewOptions& view_options,
                  GalleryState& state) {
    const Row& row = rows[state.row];
    const std::size_t count = rows.size(), parameters = std::max<std::size_t>(row.parameters.size(), 1);
    switch (command) {
        case Action::PageDown:
            go_to_row((state.row + 1) % count, state);
            return "";
        case Action::PageUp:
            go_to_row((state.row + count - 1) % count, state);
            return "";
        case Action::DialUp:
            state.chosen = (state.chosen + parameters - 1) % parameters;
            return "";
        case Action::DialDown:
            state.chosen = (state.chosen + 1) % parameters;
            return "";
        case Action::DialCoarser:
        case Action::DialFiner:
            change_parameter(row, command == Action::DialFiner ? 1 : -1, state);
            return "";
        default:
            break;
    }
    const bool is_of_game = std::find(kKeysOfTheGame.begin(), kKeysOfTheGame.end(), command) != kKeysOfTheGame.end();
    return is_of_game ? apply(command, view_options, window) : "";
}

Gallery::Gallery(std::shared_ptr<const LoadedLevel> loaded, ViewOptions& view_options, Platform& platform)
    : loaded_(std::move(loaded)),
      data_(loaded_->data),
      assets_{data_.level, data_.colormap, text_colours_of(data_.palette)},
      menu_look_(data_.palette),
      rows_(gallery_rows()),
      platform_(platform),
      view_options_(view_options),
      state_(start_of_gallery(rows_)),
      start_us_(platform.now_us()),
      now_us_(start_us_) {
    show("{page-down}: next row    {help}: keys");
}

// A press of the mouse or on a touch screen turns the page: in the left half back, else forward.
void Gallery::advance(const Controls& controls, std::uint64_t now_us) {
    now_us_ = now_us;
    std::vector<Action> commands = controls.commands;
    const WindowSize window = platform_.window_size();
    if (controls.pointer && controls.pointer->is_pressed)
        commands.push_back(controls.pointer->x_px < window.width_px / 2 ? Action::PageUp : Action::PageDown);
    for (const Action command : commands) {
        wants_screenshot_ |= command == Action::Screenshot;
        const std::string message = apply(command, rows_, window, view_options_, state_);
        if (!message.empty()) show(message);
    }
    if (!commands.empty()) is_drawn_ = false;
}

void Gallery::open_page(Action command, MenuPages& pages) {
    if (command == Action::Menu) pages.open_gallery();
    if (command == Action::ShowHelp) pages.open_keys();
    if (command == Action::FrameCost) pages.open_figures();
}

ShownPicture Gallery::draw(bool is_behind_menu) {
    const ScreenMode mode = picture_in(platform_.window_size(), view_options_.preferences).mode;
    if (!is_drawn_ || drawn_with_ != view_options_.preferences || mode_ != mode) draw_picture(mode);
    shown_ = picture_;
    const Framebuffer canvas{shown_.data(), mode.width_px, mode.height_px, mode.width_px};
    if (wants_screenshot_) show(save_screenshots(canvas, data_.palette, mode));
    wants_screenshot_ = false;
    if (!is_behind_menu) draw_over();
    return {canvas, data_.palette, shown_rect(view_options_.preferences, platform_.window_size())};
}

void Gallery::draw_picture(const ScreenMode& mode) {
    drawn_with_ = view_options_.preferences;
    mode_ = mode;
    picture_.resize(pixel_count(mode.width_px, mode.height_px));
    const Row& row = rows_[state_.row];
    const auto time_ms = static_cast<std::int64_t>((now_us_ - start_us_) / 1000);
    const RowInput input{assets_, mode, settings_of(drawn_with_), state_.values[state_.row], time_ms};
    const Framebuffer canvas{picture_.data(), mode.width_px, mode.height_px, mode.width_px};
    try {
        figures_ = draw_row(row, input, state_.chosen, canvas);
    } catch (const std::bad_alloc&) {  // under DOS; what the row had taken is free again
        figures_ = {};
        std::fill(picture_.begin(), picture_.end(), assets_.text.dark);
        show("This row needs more memory than there is");
    }
    const std::string number = std::to_string(state_.row + 1) + " of " + std::to_string(rows_.size());
    platform_.set_title(("Oblong - the gallery, " + number + ": " + std::string(row.name)).c_str());
    is_drawn_ = true;
}

std::string Gallery::figures() const {
    const Row& row = rows_[state_.row];
    std::string text = std::string(row.seeds) + "\n" + std::string(row.source) + "\n" + std::string(row.test) + "\n";
    for (const Figure& figure : figures_) text += "\n" + figure_text(figure);
    for (const std::string_view note : row.notes) text += "\n\n" + std::string(note);
    return text;
}

void Gallery::show(const std::string& message) {
    messages_.show(view_options_.key_names(platform_).in(message));
}

void Gallery::draw_over() {
    const ScreenMode& mode = mode_;
    const Framebuffer canvas{shown_.data(), mode.width_px, mode.height_px, mode.width_px};
    const TextColours colours{assets_.text.bright, assets_.text.dark,
                              text_scale_in(mode.width_px, mode.height_px, drawn_with_.text_scale)};
    const Framebuffer below_header = part_of(canvas, {0, kHeader_px, canvas.width_px, canvas.height_px - kHeader_px});
    draw_hud({}, messages_, now_us_, below_header.height_px, colours, menu_look_.veil, below_header);
}

std::unique_ptr<GameScreen> open_gallery(std::shared_ptr<const LoadedLevel> museum, ViewOptions& view_options,
                                         Platform& platform) {
    return std::make_unique<Gallery>(std::move(museum), view_options, platform);
}

}  // namespace oblong
