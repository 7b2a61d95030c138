#include "engine/platform/dos/kernel/kernel.h"
#include "engine/platform/dos/kernel/ports.h"

// Without paging, addresses are physical. The heap grows up from the program's end, pages are taken down from the end
// of memory.

namespace oblong::dos {
namespace {

constexpr std::uint32_t kMegabyte = 1 << 20, kMostMemory = 64 * kMegabyte;
// If the heap cannot grow, the C library asks for 1 MB of pages instead.
constexpr std::uint32_t kHeapReserve = kMegabyte;
bool is_taken[kMostMemory / kPage];
std::uint32_t first, heap_end, end, most;
const std::uint8_t* stack;
std::int32_t taken;  // pages beyond those of the program and its archive; below 0 if some of these are free

// Kilobytes above 1 MB, as the BIOS has stored them in the CMOS memory.
std::uint32_t kilobytes() {
    const auto read = [](std::uint8_t cell) {
        write_port(0x70, cell);
        return std::uint32_t{read_port(0x71)};
    };
    return read(0x30) | read(0x31) << 8;
}

void note_use() {
    const std::uint32_t used = heap_end - kMegabyte + static_cast<std::uint32_t>(taken) * kPage;
    if (used > most) most = used;
}

// The end of the smallest range of free pages of at least this size, outside the heap and the `reserve` behind it; 0:
// none.
std::uint32_t find_room(std::uint32_t size, std::uint32_t reserve) {
    std::uint32_t room = 0, best = 0, best_end = 0;
    for (std::uint32_t at = kPage; at <= end; at += kPage) {
        const bool is_of_heap = at >= first && at < heap_end + reserve;
        const bool is_free = at < end && !is_taken[at / kPage] && !is_of_heap;
        if (is_free) {
            room += kPage;
            continue;
        }
        if (room >= size && (best == 0 || room < best)) best = room, best_end = at;
        room = 0;
    }
    return best_end;
}

}  // namespace

void start_memory(std::uint32_t first_free) {
    end = kMegabyte + kilobytes() * 1024;
    if (end > kMostMemory) end = kMostMemory;
    end &= ~(kPage - 1);
    first = heap_end = whole_pages(first_free);
    for (std::uint32_t at = 0; at < first; at += kPage) is_taken[at / kPage] = true;
}

std::uint32_t move_heap_end(std::uint32_t wanted) {
    if (wanted < first || wanted > end) return heap_end;
    for (std::uint32_t at = whole_pages(heap_end); at < wanted; at += kPage)
        if (is_taken[at / kPage]) return heap_end;
    if (wanted > heap_end) memset(reinterpret_cast<void*>(heap_end), 0, wanted - heap_end);
    heap_end = wanted;
    note_use();
    return heap_end;
}

void* take_pages(std::uint32_t bytes) {
    const std::uint32_t size = whole_pages(bytes);
    std::uint32_t room_end = find_room(size, kHeapReserve);
    if (room_end == 0) room_end = find_room(size, 0);
    if (room_end == 0) return nullptr;
    const std::uint32_t at = room_end - size;
    for (std::uint32_t page = at; page < at + size; page += kPage) is_taken[page / kPage] = true;
    taken += static_cast<std::int32_t>(size / kPage);
    note_use();
    return memset(reinterpret_cast<void*>(at), 0, size);
}

void free_pages(const void* bytes, std::uint32_t size) {
    const std::uint32_t at = reinterpret_cast<std::uint32_t>(bytes);
    if (at >= end || size > end - at) return;
    for (std::uint32_t page = whole_pages(at); page + kPage <= at + size; page += kPage) {
        taken -= is_taken[page / kPage];
        is_taken[page / kPage] = false;
    }
}

std::uint8_t* take_stack() {
    auto* const pages = static_cast<std::uint8_t*>(take_pages(kStackSize));
    stack = pages;
    return pages;
}

// What the stack has never used is zeros.
MemoryState memory_state() {
    std::uint32_t unused = 0;
    while (unused < kStackSize && stack[unused] == 0) ++unused;
    return {end - kMegabyte, most, emulated_instructions(), kStackSize - unused};
}

}  // namespace oblong::dos
