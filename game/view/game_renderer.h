#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/frame/frame.h"
#include "engine/frame/workspace.h"
#include "engine/programs/frame_log.h"
#include "engine/programs/rendering_times.h"
#include "engine/raster/lines.h"
#include "game/level/load.h"
#include "game/view/shown_view.h"
#include "game/view/view_size.h"

namespace oblong {

/// Draws a game into its own framebuffer.
class GameRenderer {
  public:
    /// `data`, `level` and `workers` outlive the renderer. If there are workers, draw() shares its work with them.
    GameRenderer(const GameData& data, const GameLevel& level, const ScreenMode& picture, Workers* workers = nullptr,
                 const ViewSize& size = {});

    void draw(const GameView& view, const Settings& settings);
    /// Like draw(), but also count or record, and slower. The canvas is the same.
    FrameCounts draw_and_count(const GameView& view, const Settings& settings);
    FrameRecord draw_and_record(const GameView& view, const Settings& settings);
    /// Draws the edges of the faces that own pixels over the picture, which must be of this view and these settings.
    void draw_edges(const GameView& view, const Settings& settings, const LineStyle& style);
    /// Draws lines from each point to the next, likewise.
    void draw_path(std::span<const Vec3<World>> points, const GameView& view, const Settings& settings,
                   const LineStyle& style);
    /// Draws, and adds the time to `times`.
    void draw_and_time(const GameView& view, const Settings& settings, RenderingTimes& times);
    /// Writes the log's channels for the last picture, which must be of this view, at most once a second.
    void note(const GameView& view, const Settings& settings, std::uint64_t now_us, FrameLog& log);
    /// The plan of the picture drawn last.
    const FramePlan& plan() const { return work_.plan; }
    /// The picture, with what is around the view.
    Framebuffer canvas() { return {pixels_.data(), picture_.width_px, picture_.height_px, picture_.width_px}; }
    const ScreenMode& picture_mode() const { return picture_; }
    const ViewSize& size() const { return size_; }
    /// The picture's part that shows the view.
    Framebuffer shown() { return part_of(canvas(), placed_.area); }
    /// The view as it is drawn, before columns are doubled.
    Framebuffer drawn();
    const ScreenMode& mode() const { return placed_.mode; }
    /// FaceTable::torn_edges of the level.
    std::size_t torn_edges() const { return work_.cache.faces.torn_edges; }

  private:
    /// A door that turns, into GameLevel::movers, and its model, into GameData::models.
    struct TurningModel {
        std::uint32_t mover;
        std::size_t model;
    };
    void finish();
    void note_models(const InterpolatedState& state);
    template <class Use>
    void use_scene(const GameView& view, Use use);

    const GameData& data_;
    const GameLevel& level_;
    ScreenMode picture_;
    ViewSize size_;
    PlacedView placed_;
    BorderColours border_;
    FrameWorkspace work_;
    std::vector<std::uint8_t> pixels_;
    std::vector<std::uint8_t> columns_;  ///< of drawn(); empty unless they are doubled
    std::vector<PlacedMesh> meshes_;
    std::vector<std::optional<std::size_t>> item_models_;  ///< of GameLevel::items, into GameData::models
    std::vector<TurningModel> turning_;
    std::vector<std::uint8_t> is_gone_;  ///< models of taken or removed entities; empty if there cannot be any
    std::vector<Angle> turned_;          ///< empty without doors that turn
};

/// Times of warm renderings of one view with one setting; a new view or setting clears them.
class ViewTimes {
  public:
    explicit ViewTimes(FrameClock clock = steady_clock_ns) : times_(kMost, clock) {}

    /// Draws the renderer's last picture once more, and times it.
    void time(const GameView& view, const Settings& settings, GameRenderer& renderer);
    const RenderingTimes& renderings() const { return times_; }

  private:
    static constexpr std::size_t kMost = 31;

    RenderingTimes times_;
    ViewSpec view_;
    Settings settings_;
};

}  // namespace oblong
