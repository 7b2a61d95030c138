#include "game/simulation/view_dials.h"

#include <algorithm>

#include "engine/level/class_keys.h"

namespace oblong {
namespace {

constexpr std::array<ViewDial, kViewDials> kViewDialRows{{{"accuracy", class_keys::kPresetValues},
                                                          {"projection", class_keys::kProjectionValues},
                                                          {"display", class_keys::kDisplayValues},
                                                          {"isometric", class_keys::kOffOn},
                                                          {"wireframe", class_keys::kWireframeValues},
                                                          {"zoom", class_keys::kZoomValues}}};

}  // namespace

std::span<const ViewDial> all_view_dials() {
    return kViewDialRows;
}

std::optional<std::uint8_t> value_named(const ViewDial& dial, std::string_view name) {
    const auto found = std::find_if(dial.values.begin(), dial.values.end(),
                                    [name](const KeyValue& value) { return value.value == name; });
    if (found == dial.values.end()) return std::nullopt;
    return static_cast<std::uint8_t>(found - dial.values.begin());
}

}  // namespace oblong
