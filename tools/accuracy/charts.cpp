#include "tools/accuracy/charts.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "tools/accuracy/notes.h"
#include "tools/accuracy/numbers.h"
#include "tools/accuracy/svg.h"

namespace oblong {

namespace {

constexpr double kFont = 12, kCharacter = 7.4;  ///< height and width of a wide letter, as the style sets it
constexpr double kLeastError = 1e-5;

/// A point of the chart: a setting, the names it goes by.
struct Mark {
    Tradeoff at;
    std::string name;
    bool is_preset = false;
};

double cost_of(const Report& report, CostAxis across, std::size_t index) {
    if (across == CostAxis::Here) return report.times.settings[index]->frame.median / 1000;
    return milliseconds_on(Processor::I486,
                           report.results[index].cost.cycles[static_cast<std::size_t>(Processor::I486)]);
}

std::vector<Mark> marks_of(const Report& report, CostAxis across) {
    std::vector<Mark> marks;
    const auto add = [&](const Configurations::Row& row, const std::string& name, bool is_preset) {
        const auto known = std::find_if(marks.begin(), marks.end(), [&](auto& m) { return m.at.index == row.index; });
        if (known != marks.end()) return;
        const double error = report.results[row.index].errors.displacement.rms;
        marks.push_back(
            {{row.index, std::max(error, kLeastError), cost_of(report, across, row.index)}, name, is_preset});
    };
    for (const Configurations::Row& preset : report.configurations.presets) add(preset, preset.name, true);
    for (const Configurations::DialRows& dial : report.configurations.dials)
        if (dial.dial->changes_work && dial.measure == Measure::Displacement)
            for (const Configurations::Row& row : dial.rows)
                add(row, std::string(dial.dial->name) + "=" + row.name, false);
    return marks;
}

struct Box {
    double left, top, right, bottom;
    bool meets(const Box& other) const {
        return left < other.right && other.left < right && top < other.bottom && other.top < bottom;
    }
};

/// Places names beside points where they cover nothing.
class Labels {
  public:
    Labels(Svg& svg, const Box& frame) : svg_(svg), frame_(frame) {}

    void reserve(DrawingPoint point, double radius) {
        taken_.push_back({point.x - radius, point.y - radius, point.x + radius, point.y + radius});
    }

    /// To the right of a point, to its left, above or below; where none is free, nowhere, or over others if it must be.
    void add(DrawingPoint point, const std::string& name, std::string_view css_class, bool is_needed) {
        const double width = static_cast<double>(name.size()) * kCharacter;
        const std::array<DrawingPoint, 6> corners{{{point.x + 9, point.y - kFont / 2},
                                                   {point.x - 9 - width, point.y - kFont / 2},
                                                   {point.x - width / 2, point.y - 9 - kFont},
                                                   {point.x - width / 2, point.y + 9},
                                                   {point.x + 7, point.y - 7 - kFont},
                                                   {point.x + 7, point.y + 7}}};
        for (const DrawingPoint& corner : corners)
            if (is_free(corner, width)) return put(corner, width, name, css_class);
        if (is_needed) put(corners[point.x + 9 + width > frame_.right ? 1 : 0], width, name, css_class);
    }

  private:
    bool is_free(DrawingPoint corner, double width) const {
        const Box box{corner.x, corner.y, corner.x + width, corner.y + kFont};
        if (box.left < frame_.left || box.right > frame_.right || box.top < frame_.top || box.bottom > frame_.bottom)
            return false;
        return std::none_of(taken_.begin(), taken_.end(), [&](const Box& other) { return box.meets(other); });
    }
    void put(DrawingPoint corner, double width, const std::string& name, std::string_view css_class) {
        svg_.text({corner.x, corner.y + kFont - 2}, "start", css_class, name);
        taken_.push_back({corner.x, corner.y, corner.x + width, corner.y + kFont});
    }

    Svg& svg_;
    Box frame_;
    std::vector<Box> taken_;
};

void draw_axes(Svg& svg, const Box& frame, const LogAxis& across, const LogAxis& down, CostAxis cost) {
    for (const double tick : across.ticks()) {
        svg.line({across.place(tick), frame.top}, {across.place(tick), frame.bottom}, "grid");
        svg.text({across.place(tick), frame.bottom + 16}, "middle", "tick", short_number_text(tick));
    }
    for (const double tick : down.ticks()) {
        svg.line({frame.left, down.place(tick)}, {frame.right, down.place(tick)}, "grid");
        svg.text({frame.left - 6, down.place(tick) + 4}, "end", "tick", short_number_text(tick));
    }
    svg.text({frame.left, 14}, "start", "axis", "\u2191 error: rms pixels that texels are out of place");
    svg.text({frame.right, frame.bottom + 34}, "end", "axis",
             cost == CostAxis::Here ? "time: \u00b5s a frame on this machine \u2192"
                                    : "cost: ms a frame on a 486 at 66 MHz, modelled \u2192");
}

/// The front as steps: up to a point's cost, the error of the one before is the best to be had.
std::vector<DrawingPoint> steps_of(const std::vector<Tradeoff>& front, const Box& frame, const LogAxis& across,
                                   const LogAxis& down) {
    std::vector<DrawingPoint> steps;
    for (const Tradeoff& point : front) {
        if (!steps.empty()) steps.push_back({across.place(point.cost), steps.back().y});
        steps.push_back({across.place(point.cost), down.place(point.error)});
    }
    steps.push_back({frame.right, steps.back().y});
    return steps;
}

std::string caption_of(const Mark& mark, CostAxis across) {
    return mark.name + ": rms " + number_text(mark.at.error) + " pixels, " + number_text(mark.at.cost) +
           (across == CostAxis::Here ? " \u00b5s" : " ms") + " a frame";
}

/// The least and the greatest cost and error.
struct Extent {
    Tradeoff least, greatest;

    explicit Extent(const std::vector<Mark>& marks) : least(marks[0].at), greatest(marks[0].at) {
        for (const Mark& mark : marks) {
            least.cost = std::min(least.cost, mark.at.cost);
            least.error = std::min(least.error, mark.at.error);
            greatest.cost = std::max(greatest.cost, mark.at.cost);
            greatest.error = std::max(greatest.error, mark.at.error);
        }
    }
};

/// Dots, and names of the presets and of what is on the front.
void draw_marks(Svg& svg, const std::vector<Mark>& marks, const std::vector<Tradeoff>& front, const Box& frame,
                CostAxis cost, const std::function<DrawingPoint(const Mark&)>& place) {
    Labels labels(svg, frame);
    for (const Mark& mark : marks) {
        const double radius = mark.is_preset ? 6 : 3.5;
        svg.circle(place(mark), radius, mark.is_preset ? "preset" : "setting", caption_of(mark, cost));
        labels.reserve(place(mark), radius);
    }
    const auto is_on_front = [&](const Mark& mark) {
        return std::any_of(front.begin(), front.end(), [&](const Tradeoff& p) { return p.index == mark.at.index; });
    };
    for (const Mark& mark : marks)
        if (mark.is_preset) labels.add(place(mark), mark.name, "name", true);
    for (const Mark& mark : marks)
        if (!mark.is_preset && is_on_front(mark)) labels.add(place(mark), mark.name, "tick", false);
}

/// What the bars of a dial's chart are drawn by.
struct DialBars {
    static constexpr double kRow = 24, kErrorLeft = 118, kErrorRight = 226, kCostLeft = 292, kCostRight = 400;

    const Report& report;
    const Configurations::DialRows& dial;
    double least_error = 1e9, most_error = kLeastError, most_cost = 0;

    DialBars(const Report& of, const Configurations::DialRows& rows) : report(of), dial(rows) {
        for (const Configurations::Row& row : dial.rows) {
            most_error = std::max(most_error, error(row));
            least_error = std::min(least_error, std::max(error(row), kLeastError));
            most_cost = std::max(most_cost, is_measured() ? time_of(report, dial, row)->high / 1000 : cost(row));
        }
    }
    bool is_measured() const { return dial.dial->changes_work; }
    double error(const Configurations::Row& row) const {
        return summary_of(report.results[row.index].errors, dial.measure).rms;
    }
    double cost(const Configurations::Row& row) const {
        return is_measured() ? time_of(report, dial, row)->median / 1000 : milliseconds_of(report, dial, row);
    }
    double cost_place(double cost) const { return kCostLeft + cost / most_cost * (kCostRight - kCostLeft); }

    void draw(const Configurations::Row& row, double top, Svg& svg) const {
        const double base = top + 14, shown = std::max(error(row), least_error / 2);
        const double error_end = LogAxis(least_error / 2, most_error, kErrorLeft, kErrorRight).place(shown);
        const bool is_default = row.index == report.configurations.default_index;
        svg.text({kErrorLeft - 6, base}, "end", is_default ? "name" : "tick", row.name);
        svg.rectangle({kErrorLeft, top + 3}, error_end - kErrorLeft, 14, "error");
        svg.text({error_end + 4, base}, "start", "tick", number_text(error(row)));
        double end = cost_place(cost(row));
        svg.rectangle({kCostLeft, top + 3}, end - kCostLeft, 14, is_measured() ? "cost" : "cost modelled");
        if (is_measured()) {
            const TimeSpread spread = *time_of(report, dial, row);
            end = cost_place(spread.high / 1000);
            svg.line({cost_place(spread.low / 1000), top + 10}, {end, top + 10}, "spread");
        }
        svg.text({end + 6, base}, "start", "tick", number_text(cost(row)));
    }
};

}  // namespace

std::string tradeoff_chart(const Report& report, CostAxis cost, double width, const std::string& css_class) {
    const std::vector<Mark> marks = marks_of(report, cost);
    const Extent extent(marks);
    const double height = 400;
    const Box frame{52, 24, width - 12, height - 42};
    const LogAxis across(extent.least.cost / 1.06, extent.greatest.cost * 1.06, frame.left, frame.right);
    const LogAxis down(extent.least.error / 2, extent.greatest.error * 2, frame.bottom, frame.top);
    Svg svg(width, height, css_class, "Error against cost of all settings");
    draw_axes(svg, frame, across, down, cost);

    std::vector<Tradeoff> all;
    for (const Mark& mark : marks) all.push_back(mark.at);
    const std::vector<Tradeoff> front = pareto_front(all);
    svg.polyline(steps_of(front, frame, across, down), "front");
    draw_marks(svg, marks, front, frame, cost, [&](const Mark& mark) {
        return DrawingPoint{across.place(mark.at.cost), down.place(mark.at.error)};
    });
    return svg.str();
}

std::string dial_chart(const Report& report, const Configurations::DialRows& dial) {
    const DialBars bars(report, dial);
    constexpr double kTop = 22;
    Svg svg(460, kTop + DialBars::kRow * static_cast<double>(dial.rows.size()), "dial",
            "Error and cost of the settings of " + std::string(dial.dial->name));
    svg.text({DialBars::kErrorLeft, 14}, "start", "axis", "rms error, log scale");
    svg.text({DialBars::kCostLeft, 14}, "start", "axis",
             bars.is_measured() ? "\u00b5s a frame, measured" : "486: ms, modelled");
    for (std::size_t i = 0; i < dial.rows.size(); ++i)
        bars.draw(dial.rows[i], kTop + DialBars::kRow * static_cast<double>(i), svg);
    return svg.str();
}

}  // namespace oblong
