#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "engine/level/entity_classes.h"

namespace oblong {

/// How the player's picture is drawn, as far as a level can ask for it: part of a tick's input, so that a demo leads to
/// the same states. Each dial's value is the index of its name in ViewDial::values.
enum class ViewDialKind : std::uint8_t { Accuracy, Projection, Display, Isometric, Wireframe, Zoom };
inline constexpr std::size_t kViewDials = 6;
using ViewDials = std::array<std::uint8_t, kViewDials>;

/// The usual picture: `bounded`, drawn for the display and shown on it, without lines.
inline constexpr ViewDials kUsualView{4, 1, 0, 0, 0, 0};

struct ViewDial {
    std::string_view key;  ///< of trigger_view
    std::span<const KeyValue> values;
};

/// In the order of ViewDialKind. An accuracy with a dial of its own turned is "other".
std::span<const ViewDial> all_view_dials();
/// The number of a dial's value; none if it has no such value.
std::optional<std::uint8_t> value_named(const ViewDial& dial, std::string_view name);

}  // namespace oblong
