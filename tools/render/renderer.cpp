#include "tools/render/renderer.h"

#include <zlib.h>

#include <algorithm>
#include <utility>

#include "engine/view/screen.h"

namespace oblong {

namespace {

/// Draws one view's frames into a canvas of its own.
class ViewRenderer {
  public:
    ViewRenderer(const RenderJob& job, FrameWorkspace& work)
        : job_(job),
          work_(work),
          pixels_(pixel_count(job.mode.width_px, job.mode.height_px)),
          times_(static_cast<std::size_t>(job.repeat)) {}

    FrameReport render(const ViewSpec& view) {
        FrameReport report;
        const FrameCounts counts = count(view, report);  // lights the surfaces that are timed
        time(view);
        report.frame_ns = times_.frame_ns();
        report.passes = times_.pass_lines(work_.plan, counts);
        report.effects = times_.effect_lines(work_.plan, counts);
        report.crc32 = static_cast<std::uint32_t>(::crc32(0, pixels_.data(), static_cast<uInt>(pixels_.size())));
        return report;
    }
    std::span<const std::uint8_t> pixels() const { return pixels_; }

  private:
    void draw(const ViewSpec& view, std::int64_t later_ms = 0) {
        Scene scene = job_.scene;
        scene.time_ms += later_ms;
        if (job_.level_models) {
            place_models(*job_.level_models, scene.time_ms, {}, meshes_);
            scene.meshes = meshes_;
        }
        draw_frame(scene, view, job_.mode, job_.settings, work_,
                   {pixels_.data(), job_.mode.width_px, job_.mode.height_px, job_.mode.width_px});
    }

    void time(const ViewSpec& view) {
        times_.clear();
        for (int i = 0; i < job_.repeat; ++i) times_.time(work_, [&] { draw(view, i * job_.time_step_ms); });
        if (job_.time_step_ms != 0) draw(view);  // the picture of the scene's own time
    }

    FrameCounts count(const ViewSpec& view, FrameReport& report) {
        FrameCounts counts;
        work_.observers.counts = &counts;
        draw(view);
        work_.observers.counts = nullptr;
        for (const std::uint8_t writes : counts.writes)
            ++(writes == 0 ? report.pixels_never : writes == 1 ? report.pixels_once : report.pixels_twice);
        report.counts = named_counts(counts);
        if (job_.hidden_surfaces) {
            const std::vector<NamedCount> more = named_counts(job_.hidden_surfaces->counts());
            report.counts.insert(report.counts.end(), more.begin(), more.end());
        }
        return counts;
    }

    const RenderJob& job_;
    FrameWorkspace& work_;
    std::vector<std::uint8_t> pixels_;
    std::vector<PlacedMesh> meshes_;
    RenderingTimes times_;
};

}  // namespace

TimeSummary summarize_times(std::vector<double> times) {
    std::sort(times.begin(), times.end());
    const std::size_t middle = times.size() / 2;
    const double median = times.size() % 2 ? times[middle] : (times[middle - 1] + times[middle]) / 2;
    return {median, times[(times.size() * 99 + 99) / 100 - 1]};
}

std::vector<FrameReport> render_views(
    const RenderJob& job, FrameWorkspace& work,
    const std::function<void(std::size_t, std::span<const std::uint8_t>)>& on_picture) {
    ViewRenderer renderer(job, work);
    std::vector<FrameReport> reports;
    for (std::size_t i = 0; i < job.views.size(); ++i) {
        reports.push_back(renderer.render(job.views[i]));
        on_picture(i, renderer.pixels());
    }
    return reports;
}

}  // namespace oblong
