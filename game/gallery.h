#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/platform/platform.h"
#include "game/hud.h"
#include "game/load.h"
#include "game/session.h"
#include "tools/gallery/row.h"

namespace oblong {

/// Which row the gallery shows, and what its parameters are set to: what keys change.
struct GalleryState {
    std::size_t row = 0;
    std::size_t chosen = 0;                         ///< of the row's parameters
    std::vector<std::vector<std::int64_t>> values;  ///< of each row's parameters
    ViewOptions view_options;
    bool lists_figures = false;  ///< all figures and notes of the row, over its picture
};

GalleryState start_of_gallery(const std::vector<Row>& rows, const ViewOptions& view_options);

/// Carries out a command: Page Down and Page Up go to the next and the previous row, up and down arrows choose a
/// parameter, left and right change it. The message that tells the user; empty where there is none.
std::string apply(Command command, const std::vector<Row>& rows, const ScreenMode& mode, WindowSize window,
                  GalleryState& state);

/// Steps through the gallery's rows until the platform closes.
class Gallery {
  public:
    /// `data` and `platform` must outlive it.
    Gallery(const GameData& data, const SessionSettings& settings, Platform& platform);

    void run();

  private:
    void show_frame();
    void draw_picture();
    void draw_over(std::uint64_t now_us);

    const GameData& data_;
    const GalleryAssets assets_;
    const std::vector<Row> rows_;
    ScreenMode mode_;
    std::string screenshot_folder_;
    Platform& platform_;
    GalleryState state_;
    RowPage page_;
    Hud hud_;
    std::vector<std::uint8_t> picture_, shown_;
    std::uint64_t start_us_ = 0;
    bool is_drawn_ = false;  ///< `picture_` is that of the state
};

}  // namespace oblong
