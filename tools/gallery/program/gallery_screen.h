#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

#include "engine/platform/platform.h"
#include "game/level/load.h"
#include "game/program/game_screen.h"
#include "game/program/session.h"
#include "game/view/hud.h"
#include "tools/gallery/row.h"

namespace oblong {

/// The gallery's state, changed by keys: the row that is shown, and the values of parameters.
struct GalleryState {
    std::size_t row = 0;
    std::size_t chosen = 0;                         ///< of the row's parameters
    std::vector<std::vector<std::int64_t>> values;  ///< of each row's parameters
};

GalleryState start_of_gallery(const std::vector<Row>& rows);

/// Runs a command: Page Down and Page Up go to the next and the previous row, up and down arrows choose a parameter,
/// left and right change it. Returns a message to the player, or "".
std::string apply(Action command, const std::vector<Row>& rows, WindowSize window, ViewOptions& view_options,
                  GalleryState& state);

/// Steps through the gallery's rows.
class Gallery final : public GameScreen {
  public:
    /// `view_options`, which keys change, and `platform` outlive it.
    Gallery(std::shared_ptr<const LoadedLevel> loaded, ViewOptions& view_options, Platform& platform);

    void advance(const Controls& controls, std::uint64_t now_us) override;
    void advance_behind_menu(std::uint64_t now_us) override { now_us_ = now_us; }
    bool is_heard(bool) const override { return false; }
    ShownPicture draw(bool is_behind_menu) override;
    const MenuLook& menu_look() const override { return menu_look_; }
    void open_page(Action command, MenuPages& pages) override;
    const std::shared_ptr<const LoadedLevel>& shared_level() const override { return loaded_; }
    std::vector<KeyHelp> key_help(const KeyNames& names) const override { return gallery_help(names); }

    /// With the notes of the current row.
    std::string figures() const override;

  private:
    void draw_picture(const ScreenMode& mode);
    void show(const std::string& message);
    void draw_over();

    std::shared_ptr<const LoadedLevel> loaded_;
    const GameData& data_;  // of loaded_
    const GalleryAssets assets_;
    const MenuLook menu_look_;
    const std::vector<Row> rows_;
    Platform& platform_;
    ViewOptions& view_options_;
    GalleryState state_;
    Figures figures_;
    Messages messages_;
    Preferences drawn_with_;  ///< the preferences of picture_
    ScreenMode mode_;         ///< of picture_
    std::vector<std::uint8_t> picture_, shown_;
    std::uint64_t start_us_, now_us_;
    bool wants_screenshot_ = false;
    bool is_drawn_ = false;  ///< `picture_` is up to date
};

/// An OpenGallery (game/program/program_parts.h).
std::unique_ptr<GameScreen> open_gallery(std::shared_ptr<const LoadedLevel> museum, ViewOptions& view_options,
                                         Platform& platform);

}  // namespace oblong
