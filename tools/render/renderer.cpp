#include "tools/render/renderer.h"

#include <zlib.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <nlohmann/json.hpp>
#include <utility>

#include "engine/accuracy/accuracy.h"
#include "engine/base/table.h"
#include "engine/frame/frame_counts.h"
#include "engine/io/doubles.h"
#include "engine/view/screen.h"

namespace oblong {

namespace {

/// Draws one view's frames into its own canvas.
class ViewRenderer {
  public:
    ViewRenderer(const RenderJob& job, FrameWorkspace& work)
        : job_(job),
          work_(work),
          pixels_(pixel_count(job.mode.width_px, job.mode.height_px)),
          times_(as_size(job.repeat)) {}

    FrameReport render(const ViewSpec& view) {
        FrameReport report;
        const std::int64_t lit_before = work_.cache.surfaces.built_texels();
        report.first_ns = time_first(view);  // lights the surfaces
        const FrameCounts counts = count(view, lit_before, report);
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

    /// With the caches as left by earlier frames.
    double time_first(const ViewSpec& view) {
        times_.clear();
        times_.time(work_, [&] { draw(view); });
        return times_.frame_ns().median;
    }

    void time(const ViewSpec& view) {
        times_.clear();
        for (int i = 0; i < job_.repeat; ++i)
            times_.time(
                work_, [&] { draw(view, i * job_.time_step_ms); }, job_.times_passes);
        if (job_.time_step_ms != 0) draw(view);  // the picture of the scene's own time
    }

    /// Counts a rendering, and the texels lit since `lit_before`, by the first rendering.
    FrameCounts count(const ViewSpec& view, std::int64_t lit_before, FrameReport& report) {
        FrameCounts counts;
        work_.observers.counts = &counts;
        draw(view);
        work_.observers.counts = nullptr;
        counts.stages.lit_texels = work_.cache.surfaces.built_texels() - lit_before;
        if (work_.cache.surfaces.colour_cube()) counts.stages.coloured_texels = counts.stages.lit_texels;
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

using Json = nlohmann::ordered_json;

std::string hexadecimal(std::uint32_t value) {
    char text[9];
    std::snprintf(text, sizeof text, "%08x", value);
    return text;
}

double rounded(double value) {
    return std::round(value * 1000) / 1000;
}

double in_microseconds(double ns) {
    return rounded(ns / 1000);
}

/// The quartiles.
Json spread_json(double low_ns, double high_ns) {
    return {in_microseconds(low_ns), in_microseconds(high_ns)};
}

Json lines_json(const std::vector<PlanLine>& lines) {
    Json json = Json::array();
    for (const PlanLine& line : lines)
        json.push_back({{"name", line.name},
                        {"pixels", line.pixels},
                        {"microseconds", in_microseconds(line.nanoseconds)},
                        {"spread", spread_json(line.low_ns, line.high_ns)}});
    return json;
}

Json frame_json(std::size_t camera, const FrameReport& frame) {
    Json counts;
    for (const NamedCount& count : frame.counts) counts[std::string(count.name)] = count.count;
    return {{"camera", camera},
            {"crc32", hexadecimal(frame.crc32)},
            {"microseconds", in_microseconds(frame.frame_ns.median)},
            {"first_microseconds", in_microseconds(frame.first_ns)},
            {"spread", spread_json(frame.frame_ns.low, frame.frame_ns.high)},
            {"pixels", {{"once", frame.pixels_once}, {"twice", frame.pixels_twice}, {"never", frame.pixels_never}}},
            {"counts", counts},
            {"passes", lines_json(frame.passes)},
            {"effects", lines_json(frame.effects)}};
}

std::string joined(std::int64_t first, char between, std::int64_t second) {
    return std::to_string(first) + between + std::to_string(second);
}

/// The dials that differ from the preset.
Json dials_json(const Accuracy& accuracy, Preset preset) {
    Json json = Json::object();
    for (const Dial& dial : all_dials())
        if (dial.get(accuracy) != dial.get(accuracy_of(preset)))
            json[std::string(dial.name)] = value_text(dial, dial.get(accuracy));
    return json;
}

/// The bound in pixels; null if the setting has none.
Json texel_error_json(const Accuracy& accuracy) {
    if (accuracy.texturing != Texturing::Bounded) return nullptr;
    return accuracy.pixel_bound_256 / 256.0;
}

Json allowed_effects_json(EffectSet allowed) {
    Json names = Json::array();
    for (std::size_t effect = 0; effect < kEffectNames.size(); ++effect)
        if (allowed.has(static_cast<Effect>(effect))) names.push_back(kEffectNames[effect]);
    return names;
}

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

TimeSummary summarize_times(const std::vector<FrameReport>& frames) {
    std::vector<double> times;
    for (const FrameReport& frame : frames) times.push_back(frame.frame_ns.median / 1000);
    return summarize_times(std::move(times));
}

std::string plan_text(const std::vector<FrameReport>& frames) {
    std::string text;
    const auto add = [&](const char* kind, const std::vector<PlanLine>& lines) {
        for (const PlanLine& line : lines) {
            char row[112];
            std::snprintf(row, sizeof row, "  %-6s %-18.*s %9lld pixels %9.1f us (%.1f to %.1f)\n", kind,
                          static_cast<int>(line.name.size()), line.name.data(), static_cast<long long>(line.pixels),
                          line.nanoseconds / 1000, line.low_ns / 1000, line.high_ns / 1000);
            text += row;
        }
    };
    for (std::size_t camera = 0; camera < frames.size(); ++camera) {
        const TimeSpread& frame = frames[camera].frame_ns;
        text += "camera " + std::to_string(camera) + "\n";
        const std::int64_t pixels =
            frames[camera].pixels_once + frames[camera].pixels_twice + frames[camera].pixels_never;
        add("frame", {{"", pixels, frame.median, frame.low, frame.high}});
        add("pass", frames[camera].passes);
        add("effect", frames[camera].effects);
    }
    return text;
}

std::string report_json(const ReportHead& head, const std::vector<FrameReport>& frames) {
    const TimeSummary times = summarize_times(frames);
    Json report{{"level", head.level},
                {"mode", joined(head.mode.width_px, 'x', head.mode.height_px)},
                {"display", joined(head.mode.display.numerator, ':', head.mode.display.denominator)},
                {"field_of_view", number_of(head.field_of_view)},
                {"accuracy", name_of(head.preset)},
                {"dials", dials_json(head.settings.accuracy, head.preset)},
                {"texel_error", texel_error_json(head.settings.accuracy)},
                {"allowed_effects", allowed_effects_json(head.settings.allowed_effects)},
                {"hidden_surfaces", item(kHiddenSurfaceNames, head.hidden_surfaces)},
                {"threads", head.threads},
                {"load_milliseconds", rounded(head.load_milliseconds)},
                {"microseconds", {{"median", rounded(times.median)}, {"p99", rounded(times.p99)}}},
                {"frames", Json::array()}};
    for (std::size_t i = 0; i < frames.size(); ++i) report["frames"].push_back(frame_json(i, frames[i]));
    return report.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";  // a file's name may be invalid UTF-8
}

}  // namespace oblong
