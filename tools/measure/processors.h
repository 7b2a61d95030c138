#pragma once

#include <array>
#include <string_view>

#include "tools/measure/operations.h"

namespace oblong {

/// A processor of the time.
enum class Processor { I386, I486, Pentium };
inline constexpr std::array kProcessors{Processor::I386, Processor::I486, Processor::Pentium};
/// "386 at 33 MHz", "486 at 66 MHz", "Pentium at 90 MHz".
std::string_view name_of(Processor processor);

/// Cycles by the processor's instruction times (sources: processors.cpp): only of operations, without jumps, waiting
/// for memory, or a Pentium's two pipelines.
double cycles_on(Processor processor, const Operations& operations);
/// Frames a second of that many cycles.
double frame_rate(Processor processor, double cycles);

}  // namespace oblong
