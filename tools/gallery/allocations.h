#pragma once

#include <cstdint>

namespace oblong {

/// What operator new gave out; over-aligned objects are not counted.
struct AllocationCount {
    std::int64_t allocations = 0, bytes = 0;
};

/// This thread's allocations since it began. A program that asks for them has an operator new that counts.
AllocationCount allocations_so_far();

/// This thread's allocations while a function runs.
template <class Run>
AllocationCount allocations_of(const Run& run) {
    const AllocationCount before = allocations_so_far();
    run();
    const AllocationCount after = allocations_so_far();
    return {after.allocations - before.allocations, after.bytes - before.bytes};
}

}  // namespace oblong
