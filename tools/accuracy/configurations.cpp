#include "tools/accuracy/configurations.h"

#include <algorithm>

#include "engine/accuracy/accuracy.h"
#include "engine/base/table.h"

namespace oblong {

namespace {

bool is_about_blocks(const Dial& dial) {
    return dial.name == "perspective" || dial.name == "pixel-bound" || dial.name == "texel-bound";
}

Configurations::DialRows rows_of(const Dial& dial, Configurations& all) {
    Accuracy base;
    Configurations::DialRows rows{&dial, measure_of(dial), "default", false, {}};
    if (dial.name == "texel-bound") {  // has no effect with other settings of perspective
        base.texturing = Texturing::BoundedTexels;
        rows.base = "default with perspective=bounded-texels";
    }
    rows.is_below_bound = rows.measure == Measure::Displacement && !is_about_blocks(dial);
    for (const DialSetting& setting : dial.settings) {
        Accuracy accuracy = base;
        dial.set(accuracy, setting.value);
        const std::size_t index = index_of(accuracy, all);
        all.has_cost[index] = true;
        if (rows.is_below_bound) accuracy.texturing = Texturing::Exact;
        rows.rows.push_back({std::string(setting.name), index, index_of(accuracy, all)});
    }
    return rows;
}

}  // namespace

std::size_t index_of(const Accuracy& accuracy, Configurations& all) {
    const auto found = std::find(all.accuracies.begin(), all.accuracies.end(), accuracy);
    if (found != all.accuracies.end()) return as_size(found - all.accuracies.begin());
    all.accuracies.push_back(accuracy);
    all.has_cost.push_back(false);
    return all.accuracies.size() - 1;
}

Measure measure_of(const Dial& dial) {
    const auto is_one_of = [&](std::initializer_list<std::string_view> names) {
        return std::find(names.begin(), names.end(), dial.name) != names.end();
    };
    if (is_one_of({"subpixel-bits"})) return Measure::WrongPixels;
    if (is_one_of({"edges"})) return Measure::EdgePixels;
    if (is_one_of({"t-junctions"})) return Measure::FreePixels;
    if (is_one_of({"light", "shades", "dither", "colours"})) return Measure::LightColour;
    if (is_one_of({"mip", "mip-bias", "floors"})) return Measure::PixelColour;
    return Measure::Displacement;
}

bool has_same_surfaces(const Accuracy& a, const Accuracy& b) {
    return a.light == b.light && a.shades == b.shades && a.dithers_light == b.dithers_light &&
           a.colour_levels == b.colour_levels;
}

Configurations make_configurations(std::span<const Dial> dials) {
    Configurations all;
    all.default_index = index_of(Accuracy{}, all);
    all.has_cost[all.default_index] = true;
    for (const Dial& dial : dials) all.dials.push_back(rows_of(dial, all));
    for (const Preset preset : kPresets) {
        const std::size_t index = index_of(accuracy_of(preset), all);
        all.presets.push_back({std::string(name_of(preset)), index, index});
        all.has_cost[index] = true;
    }
    return all;
}

}  // namespace oblong
