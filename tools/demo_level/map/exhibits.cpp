#include "tools/demo_level/map/exhibits.h"

#include <algorithm>

namespace oblong::map_source {
namespace {

MapEntity brush_entity(const std::string& classname, const Box& box) {
    return {{{"classname", classname}}, {make_box(box, "brass_trim")}};
}

}  // namespace

std::string lens_target(std::size_t exhibit) {
    return "lens" + std::to_string(exhibit + 1);
}

void add_lens(Draft& draft, const Point& floor, const std::string& exhibit) {
    const auto number =
        static_cast<std::size_t>(std::find(kExhibits.begin(), kExhibits.end(), exhibit) - kExhibits.begin());
    const Point place{floor.x, floor.y, floor.z + 40};
    draft.add_point("item_lens", place,
                    {{"target", lens_target(number)},
                     {"netname", exhibit},
                     {"glass", "glass" + std::to_string(number + 1)},
                     {"message", "The lens of " + exhibit}});
    draft.add_point("trigger_relay", place, {{"targetname", lens_target(number)}, {"target", kLensCounter}});
}

void add_caption(Draft& draft, const Box& box, const std::string& first, const std::string& second) {
    MapEntity trigger = brush_entity("trigger_once", box);
    trigger.pairs.emplace_back("message", second.empty() ? first : first + "\\n" + second);
    draft.add_entity(std::move(trigger));
}

void add_lens_counter(Draft& draft) {
    constexpr int kSilent = 1;  // spawnflag: it does not say how many are missing
    MapEntity counter = brush_entity("trigger_counter", {{-8, -408, 232}, {8, -392, 236}});
    counter.pairs.insert(counter.pairs.end(), {{"targetname", kLensCounter},
                                               {"target", kTowerGate},
                                               {"count", std::to_string(kLensCount)},
                                               {"spawnflags", std::to_string(kSilent)},
                                               {"message", "All twelve lenses: the tower is open"}});
    draft.add_entity(std::move(counter));
}

}  // namespace oblong::map_source
