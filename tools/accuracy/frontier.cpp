#include "tools/accuracy/frontier.h"

#include <algorithm>
#include <limits>

#include "engine/base/table.h"
#include "tools/accuracy/configurations.h"

namespace oblong {

namespace {

/// The same if the dials that it does not depend on are turned.
Accuracy without_idle_dials(Accuracy accuracy) {
    if (accuracy.texturing != Texturing::Bounded) accuracy.pixel_bound_256 = Accuracy{}.pixel_bound_256;
    if (accuracy.texturing != Texturing::BoundedTexels) accuracy.texel_bound_256 = Accuracy{}.texel_bound_256;
    return accuracy;
}

/// The others' errors are of another kind, or their costs too small to count.
bool is_of_spans(const Dial& dial) {
    return dial.read_in.starts_with("engine/raster/") && measure_of(dial) == Measure::Displacement;
}

std::vector<Accuracy> neighbours_of(const Accuracy& accuracy) {
    std::vector<Accuracy> neighbours;
    for (const Dial& dial : all_dials()) {
        if (!is_of_spans(dial)) continue;
        for (const DialSetting& setting : dial.settings) {
            Accuracy turned = accuracy;
            dial.set(turned, setting.value);
            neighbours.push_back(without_idle_dials(turned));
        }
    }
    return neighbours;
}

/// Whether displacement is all that their errors differ by: a floor of one colour, say, has no texels to be displaced.
bool are_comparable(const Accuracy& a, const Accuracy& b) {
    return std::all_of(all_dials().begin(), all_dials().end(),
                       [&](const Dial& dial) { return is_of_spans(dial) || dial.get(a) == dial.get(b); });
}

/// By rising cost, the trials with less than 1 / `step` of the error of all before that they can be compared with.
void add_front(const std::vector<Trial>& trials, std::size_t cost, double step, std::vector<Accuracy>& front) {
    std::vector<const Trial*> sorted;
    for (const Trial& trial : trials) sorted.push_back(&trial);
    std::stable_sort(sorted.begin(), sorted.end(),
                     [&](const Trial* a, const Trial* b) { return item(a->costs, cost) < item(b->costs, cost); });
    std::vector<const Trial*> best;
    for (const Trial* trial : sorted) {
        if (std::any_of(best.begin(), best.end(), [&](const Trial* other) {
                return trial->error * step > other->error && are_comparable(trial->accuracy, other->accuracy);
            }))
            continue;
        best.push_back(trial);
        if (std::find(front.begin(), front.end(), trial->accuracy) == front.end()) front.push_back(trial->accuracy);
    }
}

std::vector<Accuracy> front_of(const std::vector<Trial>& trials, double step) {
    std::vector<Accuracy> front;
    for (const std::size_t cost : {0, 1}) add_front(trials, cost, step, front);
    return front;
}

}  // namespace

std::vector<Accuracy> search_frontier(const std::function<Trial(const Accuracy&)>& measure, std::size_t most_trials,
                                      double step) {
    std::vector<Trial> trials;
    const auto try_out = [&](const Accuracy& accuracy) {
        const auto is_same = [&](const Trial& trial) { return trial.accuracy == accuracy; };
        if (trials.size() < most_trials && std::none_of(trials.begin(), trials.end(), is_same))
            trials.push_back(measure(accuracy));
    };
    for (const Preset preset : kPresets) try_out(without_idle_dials(accuracy_of(preset)));
    std::vector<Accuracy> turned;
    const auto is_new = [&](const Accuracy& accuracy) {
        return std::find(turned.begin(), turned.end(), accuracy) == turned.end();
    };
    while (true) {
        const std::vector<Accuracy> front = front_of(trials, step);
        const auto next = std::find_if(front.begin(), front.end(), is_new);
        if (next == front.end() || trials.size() >= most_trials) return front;
        turned.push_back(*next);
        for (const Accuracy& accuracy : neighbours_of(*next)) try_out(accuracy);
    }
}

std::string name_of_combination(const Accuracy& accuracy) {
    std::string name;
    std::size_t fewest = std::numeric_limits<std::size_t>::max();
    for (const Preset preset : kPresets) {
        std::string words(name_of(preset));
        std::size_t different = 0;
        for (const Dial& dial : all_dials()) {
            if (dial.get(accuracy) == dial.get(accuracy_of(preset))) continue;
            words += " " + std::string(dial.name) + "=" + value_text(dial, dial.get(accuracy));
            ++different;
        }
        if (different >= fewest) continue;
        fewest = different;
        name = words;
    }
    return name;
}

}  // namespace oblong
