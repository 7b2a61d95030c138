#include "tools/accuracy/report.h"

#include <algorithm>

#include "engine/base/table.h"
#include "engine/pictures/picture.h"
#include "tools/accuracy/errors.h"
#include "tools/accuracy/frontier.h"

namespace oblong {

namespace {

/// A frame to measure.
struct FrameJob {
    LevelFrames& frames;
    std::size_t level, camera;
    const reference::Palette& palette;
    const FrameTruth& truth;

    const Camera& view() const { return frames.level().cameras[camera]; }
    PixelErrors measure(const Accuracy& accuracy) const {
        const FrameRecord& record = frames.record(view(), accuracy);
        return measure_frame({frames.level(), view(), truth, palette, record, frames.pixels()});
    }
};

/// All input of the measurements, by level and frame.
struct Preparation {
    std::vector<LevelFrames> levels;
    std::vector<reference::Palette> palettes;
    std::vector<std::vector<FrameTruth>> truths;

    std::vector<FrameJob> jobs() {
        std::vector<FrameJob> all;
        for (std::size_t level = 0; level < levels.size(); ++level)
            for (std::size_t camera = 0; camera < truths[level].size(); ++camera)
                all.push_back({levels[level], level, camera, palettes[level], truths[level][camera]});
        return all;
    }
};

CountedCost count_cost(const Accuracy& accuracy, std::span<const FrameJob> jobs) {
    CountedCost cost;
    cost.frames = std::ssize(jobs);
    for (const FrameJob& job : jobs) {
        job.frames.forget_surfaces(accuracy);
        const Events unlit = events_of(job.frames.count(job.view(), accuracy), accuracy),
                     lit = events_of(job.frames.count(job.view(), accuracy), accuracy);
        for (std::size_t i = 0; i < kEventCount; ++i) {
            cost.drawing[i] += lit[i];
            cost.lighting[i] += unlit[i] - lit[i];
        }
    }
    return cost;
}

/// For each measure, the frame with a setting's largest error.
struct WorstFrames {
    std::array<std::size_t, kMeasureCount> job{};
    std::array<double, kMeasureCount> rms{};

    void add(const PixelErrors& errors, std::size_t index) {
        for (std::size_t measure = 0; measure < rms.size(); ++measure) {
            const double found = rms_of(errors[measure]);
            if (found <= rms[measure]) continue;
            rms[measure] = found;
            job[measure] = index;
        }
    }
};

SettingResult measure_setting(const Accuracy& accuracy, bool has_cost, std::span<const FrameJob> jobs,
                              std::size_t level_count, WorstFrames& worst) {
    ErrorCollector all;
    std::vector<ErrorCollector> by_level(level_count);
    for (std::size_t i = 0; i < jobs.size(); ++i) {
        const PixelErrors errors = jobs[i].measure(accuracy);
        all.add(errors);
        by_level[jobs[i].level].add(errors);
        worst.add(errors, i);
    }
    SettingResult result{all.summarize(), {}, has_cost ? count_cost(accuracy, jobs) : CountedCost{}};
    for (const ErrorCollector& level : by_level) result.by_level.push_back(level.summarize());
    return result;
}

/// Adds the best combinations of dials that a search in some of the frames finds.
void add_frontier(std::span<const FrameJob> jobs, std::size_t most_trials, const map::WorkSharing& work,
                  Configurations& all) {
    constexpr std::size_t kMostFrames = 16;
    constexpr double kStep = 1.1;
    std::vector<FrameJob> some;
    for (std::size_t i = 0; i < jobs.size(); i += jobs.size() / kMostFrames + 1) some.push_back(jobs[i]);
    work.begin("combinations of dials", most_trials);
    const auto measure = [&](const Accuracy& accuracy) {
        SettingResult result;
        WorstFrames worst;
        work.for_each(
            1, [&](std::size_t) { result = measure_setting(accuracy, true, some, some.back().level + 1, worst); });
        return Trial{accuracy,
                     item(result.errors, Measure::Displacement).rms,
                     {result.cost.of_drawing(Currency::Instructions), result.cost.of_drawing(Currency::Cycles486)}};
    };
    for (const Accuracy& accuracy : search_frontier(measure, most_trials, kStep)) {
        const std::size_t index = index_of(accuracy, all);
        all.has_cost[index] = true;
        all.frontier.push_back({name_of_combination(accuracy), index, index});
    }
}

HeatMap draw_heat_map(const Configurations::Row& row, const Accuracy& accuracy, Measure measure, const FrameJob& job) {
    const PixelErrors errors = job.measure(accuracy);
    const std::vector<float>& values = item(errors, measure);
    return {row.name, job.frames.level().name, job.camera, rms_of(values),
            encode_indexed_png(heat_pixels(values, measure), kMeasuredMode.width_px, kMeasuredMode.height_px,
                               heat_palette())};
}

/// Heat maps of a dial's setting with the largest error and of its most exact one, in the frame with the former's
/// largest error.
std::vector<HeatMap> draw_heat_maps(const Configurations::DialRows& dial, const Report& report,
                                    std::span<const FrameJob> jobs, std::span<const WorstFrames> worst) {
    const auto rms = [&](const Configurations::Row& row) {
        return item(report.results[row.index].errors, dial.measure).rms;
    };
    const auto furthest =
        std::max_element(dial.rows.begin(), dial.rows.end(), [&](auto& a, auto& b) { return rms(a) < rms(b); });
    const FrameJob& job = jobs[item(worst[furthest->index].job, dial.measure)];
    const auto draw = [&](const Configurations::Row& row) {
        return draw_heat_map(row, report.configurations.accuracies[row.index], dial.measure, job);
    };
    std::vector<HeatMap> maps{draw(*furthest)};
    if (&*furthest != &dial.rows.back()) maps.push_back(draw(dial.rows.back()));
    return maps;
}

Preparation prepare(std::span<const MeasuredPlace> places, int samples_per_axis, const map::WorkSharing& work) {
    Preparation prepared;
    for (const MeasuredPlace& place : places) {
        prepared.levels.emplace_back(place.level, place.colormap);
        prepared.palettes.push_back(reference_palette(place.palette));
        std::vector<FrameTruth>& truths = prepared.truths.emplace_back();
        work.for_each(place.level.cameras.size(), [&](std::size_t i) {
            truths.push_back(make_frame_truth(prepared.levels.back(), place.level.cameras[i], prepared.palettes.back(),
                                              samples_per_axis));
        });
    }
    return prepared;
}

LevelSummary summary_of_level(const MeasuredLevel& level, std::span<const FrameTruth> truths) {
    double close_calls = 0;
    for (const FrameTruth& truth : truths)
        close_calls += static_cast<double>(std::count(truth.is_close_call.begin(), truth.is_close_call.end(), true));
    const double pixels = static_cast<double>(truths.size()) * kMeasuredMode.width_px * kMeasuredMode.height_px;
    return {level.name, level.about, level.cameras.size(), level.exact.faces.size(), 1000 * close_calls / pixels};
}

}  // namespace

Report measure_all(const Configurations& settings, std::span<const MeasuredPlace> places, const Effort& effort,
                   map::Progress* progress) {
    const map::WorkSharing work(nullptr, progress);  // in order, as frames share workspaces
    Report report;
    report.configurations = settings;
    const Configurations& configurations = report.configurations;
    report.samples_per_axis = effort.samples_per_axis;
    report.is_quick = effort.is_quick;
    for (const MeasuredPlace& place : places) report.frames += place.level.cameras.size();

    work.begin("the exact frames", report.frames);
    Preparation prepared = prepare(places, effort.samples_per_axis, work);
    const std::vector<FrameJob> jobs = prepared.jobs();
    for (std::size_t i = 0; i < places.size(); ++i)
        report.levels.push_back(summary_of_level(places[i].level, prepared.truths[i]));

    if (effort.most_trials > 0) add_frontier(jobs, effort.most_trials, work, report.configurations);
    std::vector<WorstFrames> worst(configurations.accuracies.size());
    work.begin("errors and events", worst.size());
    work.for_each(worst.size(), [&](std::size_t i) {
        report.results.push_back(
            measure_setting(configurations.accuracies[i], configurations.has_cost[i], jobs, places.size(), worst[i]));
    });
    for (const Configurations::DialRows& dial : configurations.dials)
        report.heat_maps.push_back(draw_heat_maps(dial, report, jobs, worst));

    report.times.settings.resize(worst.size());
    if (effort.rounds == 0) return report;
    work.begin("times", as_size(effort.rounds));
    report.times = time_frames(configurations, prepared.levels, effort.rounds, work);
    return report;
}

}  // namespace oblong
