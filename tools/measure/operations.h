#pragma once

#include <array>
#include <cstdint>
#include <string_view>

#include "engine/accuracy/accuracy.h"
#include "engine/base/table.h"
#include "engine/frame/frame_counts.h"

namespace oblong {

/// The integer width of an operation: the narrowest that holds its operands.
enum class Width { Bits16, Bits32, Bits64 };
inline constexpr std::array<std::string_view, 3> kWidthNames{"16", "32", "64"};

/// The number of operations of each width.
struct ByWidth {
    std::array<std::int64_t, 3> counts{};

    std::int64_t& operator[](Width width) { return item(counts, width); }
    std::int64_t operator[](Width width) const { return item(counts, width); }
    std::int64_t total() const { return counts[0] + counts[1] + counts[2]; }
    ByWidth& operator+=(const ByWidth& more);
    bool operator==(const ByWidth&) const = default;
};

/// Operations by kind and width. Addresses and loops count as their additions; jumps do not count.
struct Operations {
    ByWidth adds;                                    ///< additions, subtractions, comparisons, shifts and masks
    ByWidth multiplications;                         ///< of two factors of this width
    ByWidth divisions;                               ///< by a divisor of this width
    std::int64_t lookups = 0;                        ///< of a table or a texel, at an address computed from data
    std::int64_t bytes_read = 0, bytes_written = 0;  ///< lookups included

    Operations& operator+=(const Operations& more);
    bool operator==(const Operations&) const = default;
};

/// A stage of a frame and its operations.
struct StageOperations {
    std::string_view stage;   ///< "vertices", "edges", "blocks", "pixels" ...
    std::int64_t events = 0;  ///< how often
    Operations operations;    ///< all together
};

inline constexpr std::size_t kStageCount = 13;

/// The operations of a frame: the number of each stage's events, as its code counts them (FrameCounts::stages), times
/// the operations of one event, which operations.cpp lists for each piece of code. tests/operations compares them with
/// the additions, multiplications and divisions of the compiled engine, counted block by block: no part of a frame of
/// the demo level differs by more than 5 %. On another level the means of a part may differ: on one of Quake's single
/// parts by up to 80 %, all divisions by 8 %, all multiplications by 11 %, all additions by 3 %. Work done once a
/// frame, or when the eye enters another leaf (1.4 % of the additions), and placed models' vertices are left out. Dials
/// that round to fewer bits make operations narrower. Integers: the same on every machine.
std::array<StageOperations, kStageCount> operations_by_stage(const FrameCounts& counts, const Accuracy& accuracy);
Operations sum_of(const std::array<StageOperations, kStageCount>& stages);

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
