#include "tools/render/renderer.h"

#include <zlib.h>

#include <algorithm>
#include <chrono>
#include <utility>

#include "engine/screen/screen.h"

namespace oblong {

namespace {

std::int64_t steady_clock_ns() {
    return std::chrono::nanoseconds(std::chrono::steady_clock::now().time_since_epoch()).count();
}

/// Draws one view's frames into a canvas of its own.
class ViewRenderer {
  public:
    ViewRenderer(const RenderJob& job, FrameWorkspace& work)
        : job_(job), work_(work), pixels_(pixel_count(job.mode.width_px, job.mode.height_px)) {}

    FrameReport render(const ViewSpec& view) {
        FrameReport report;
        count(view, report);
        report.microseconds = timed(view);
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

    double timed(const ViewSpec& view) {
        std::vector<double> microseconds;
        for (int i = 0; i < job_.repeat; ++i) {
            const auto start = std::chrono::steady_clock::now();
            draw(view, i * job_.time_step_ms);
            const std::chrono::duration<double, std::micro> taken = std::chrono::steady_clock::now() - start;
            microseconds.push_back(taken.count());
        }
        if (job_.time_step_ms != 0) draw(view);  // the picture of the scene's own time
        return summarize_times(std::move(microseconds)).median;
    }

    void count(const ViewSpec& view, FrameReport& report) {
        work_.counts = std::make_unique<FrameCounts>();
        draw(view);
        const std::unique_ptr<FrameCounts> counts = std::move(work_.counts);
        for (const std::uint8_t writes : counts->writes)
            ++(writes == 0 ? report.pixels_never : writes == 1 ? report.pixels_once : report.pixels_twice);
        report.counts = named_counts(*counts);
        const PassTimes times = time_passes(view);
        report.passes = pass_lines(work_.plan, *counts, times);
        report.effects = effect_lines(work_.plan, *counts, times);
    }

    PassTimes time_passes(const ViewSpec& view) {
        work_.times = std::make_unique<PassTimes>(PassTimes{steady_clock_ns});
        draw(view);
        return *std::exchange(work_.times, nullptr);
    }

    const RenderJob& job_;
    FrameWorkspace& work_;
    std::vector<std::uint8_t> pixels_;
    std::vector<PlacedMesh> meshes_;
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
