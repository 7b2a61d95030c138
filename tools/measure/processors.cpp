#include <array>

#include "engine/base/table.h"
#include "tools/measure/operations.h"

namespace oblong {

namespace {

/// Cycles of one operation of 16, 32 and 64 bits.
struct InstructionTimes {
    std::string_view name;
    double megahertz;
    std::array<double, 3> add, multiply, divide;
    double lookup, byte_read, byte_written;
};

/// 16 and 32 bits: Intel's 80386 and i486 programmer's reference manuals, Agner Fog's tables for the Pentium. A
/// product's time grows with its factor's bits on the 386 and the 486 (max(ceil(log2 m), 3) + 6, and 13 to 42): taken
/// for full factors. 64 bits in 32-bit instructions: an addition is two (ADD, ADC); a product three products and three
/// additions; a quotient by a divisor of up to 32 significant bits two divisions and four additions. A byte read or
/// written is a quarter of a MOV of 32 bits; a lookup, whose bytes are also read, adds what is left of a whole one.
constexpr std::array<InstructionTimes, 3> kTimes{{
    {"386 at 33 MHz", 33, {2, 2, 4}, {22, 38, 120}, {27, 43, 94}, 3, 1, 0.5},
    {"486 at 66 MHz", 66, {1, 1, 2}, {26, 42, 129}, {27, 43, 90}, 0.75, 0.25, 0.25},
    {"Pentium at 90 MHz", 90, {1, 1, 2}, {10, 10, 33}, {30, 46, 96}, 0.75, 0.25, 0.25},
}};

double weighted(const ByWidth& operations, const std::array<double, 3>& cycles) {
    double sum = 0;
    for (std::size_t i = 0; i < cycles.size(); ++i) sum += static_cast<double>(operations.counts[i]) * cycles[i];
    return sum;
}

}  // namespace

std::string_view name_of(Processor processor) {
    return item(kTimes, processor).name;
}

double cycles_on(Processor processor, const Operations& operations) {
    const InstructionTimes& times = item(kTimes, processor);
    return weighted(operations.adds, times.add) + weighted(operations.multiplications, times.multiply) +
           weighted(operations.divisions, times.divide) + static_cast<double>(operations.lookups) * times.lookup +
           static_cast<double>(operations.bytes_read) * times.byte_read +
           static_cast<double>(operations.bytes_written) * times.byte_written;
}

double frame_rate(Processor processor, double cycles) {
    return item(kTimes, processor).megahertz * 1e6 / cycles;
}

}  // namespace oblong
