#include "engine/surface/surface_cache.h"

namespace oblong {

SurfaceCache::Found SurfaceCache::get(std::size_t slot, std::size_t bytes, const SurfaceKey& key) {
    Slot& entry = slots_[slot];
    if (entry.generation == generation_) {
        const bool is_valid = entry.key == key;
        if (!is_valid) entry.key = key;
        return {arena_.get() + entry.offset, is_valid};
    }
    if (bytes > arena_bytes_ - used_bytes_) clear();
    entry = {key, static_cast<std::uint32_t>(used_bytes_), generation_};
    used_bytes_ += bytes;
    return {arena_.get() + entry.offset, false};
}

}  // namespace oblong
