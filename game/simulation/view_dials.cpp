#include "game/simulation/view_dials.h"

#include <algorithm>

namespace oblong {
namespace {

constexpr std::array<std::string_view, 7> kAccuracies{"1991", "1994", "1996", "pixel", "bounded", "exact", "other"};
constexpr std::array<std::string_view, 2> kProjections{"square", "display"};
constexpr std::array<std::string_view, 3> kDisplays{"display", "square", "fill"};
constexpr std::array<std::string_view, 2> kOff{"off", "on"};
constexpr std::array<std::string_view, 3> kWireframes{"off", "over", "alone"};
constexpr std::array<std::string_view, 13> kZooms{"off", "10", "20", "30",  "40",  "50", "60",
                                                  "70",  "80", "90", "100", "110", "120"};

constexpr std::array<ViewDial, kViewDials> kViewDialRows{{{"accuracy", kAccuracies},
                                                          {"projection", kProjections},
                                                          {"display", kDisplays},
                                                          {"isometric", kOff},
                                                          {"wireframe", kWireframes},
                                                          {"zoom", kZooms}}};

}  // namespace

std::span<const ViewDial> all_view_dials() {
    return kViewDialRows;
}

std::optional<std::uint8_t> value_named(const ViewDial& dial, std::string_view name) {
    const auto found = std::find(dial.values.begin(), dial.values.end(), name);
    if (found == dial.values.end()) return std::nullopt;
    return static_cast<std::uint8_t>(found - dial.values.begin());
}

}  // namespace oblong
