#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/accuracy/accuracy.h"
#include "engine/base/table.h"
#include "engine/frame/frame_counts.h"

namespace oblong {

/// What an event is paid in: instructions that two builds of the engine run, and cycles of processors of the time.
enum class Currency { Instructions, Instructions486, Cycles386, Cycles486, CyclesPentium };
inline constexpr std::size_t kCurrencyCount = 5;

inline constexpr std::size_t kEventCount = 35;

/// The events of one frame, or their sums of several.
using Events = std::array<std::int64_t, kEventCount>;

/// The priced events of a frame: counts of its stages, apart by the settings that do other work for them. The events of
/// lit texels are those of surfaces that were not in the cache.
Events events_of(const FrameCounts& counts, const Accuracy& accuracy);
/// "bounded blocks", "edge rows" ...
std::string_view event_name(std::size_t event);

/// What these events cost: the sum of their prices, which are fitted to counted instructions. How far they are off is
/// said beside them (prices.h). What has no event of its own is in the price of what goes along with it.
std::int64_t cost_of(const Events& events, Currency currency);

/// A processor of the time.
enum class Processor { I386, I486, Pentium };
inline constexpr std::array kProcessors{Processor::I386, Processor::I486, Processor::Pentium};
/// "386 at 33 MHz", "486 at 66 MHz", "Pentium at 90 MHz".
std::string_view name_of(Processor processor);

/// Cycles by published times of the i486 build's instructions (tests/operations/costs.py), without waiting for memory
/// or a Pentium's two pipelines.
std::int64_t cycles_on(Processor processor, const Events& events);
/// Cycles a microsecond.
std::int64_t megahertz_of(Processor processor);
/// Frames of so many cycles in ten seconds, rounded.
std::int64_t frame_rate_10(Processor processor, std::int64_t cycles);

}  // namespace oblong
