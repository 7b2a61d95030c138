#include "tools/gallery/allocations.h"

#include <cstdlib>
#include <new>

namespace {

thread_local oblong::AllocationCount allocation_count;

}  // namespace

// The standard library's other forms of new and delete call these.

void* operator new(std::size_t bytes) {
    ++allocation_count.allocations;
    allocation_count.bytes += static_cast<std::int64_t>(bytes);
    if (void* const memory = std::malloc(bytes == 0 ? 1 : bytes)) return memory;
    throw std::bad_alloc();
}

void operator delete(void* memory) noexcept {
    std::free(memory);
}

void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace oblong {

AllocationCount allocations_so_far() {
    return allocation_count;
}

}  // namespace oblong
