#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace oblong {

/// Lit surfaces, kept while they are valid. One slot for each face and mip level; the texels lie in one arena that is
/// filled from the start and emptied when it is full. Caching never changes a picture: a rebuilt surface is the same.
class SurfaceCache {
  public:
    SurfaceCache(std::size_t slot_count, std::size_t arena_bytes)
        : slots_(slot_count), arena_(new std::uint8_t[arena_bytes]), arena_bytes_(arena_bytes) {}

    struct Found {
        std::uint8_t* texels;
        bool is_valid;  ///< false: the caller must write them
    };

    /// The texels of a slot, `bytes` of them (at most the arena's size), lit by the styles whose brightness `light_key`
    /// packs. Texels got before may be overwritten: use them before the next call.
    Found get(std::size_t slot, std::size_t bytes, std::uint64_t light_key);

    /// Forgets all surfaces.
    void clear() {
        used_bytes_ = 0;
        ++generation_;
    }

  private:
    struct Slot {
        std::uint64_t light_key = 0;
        std::size_t offset = 0;
        std::uint32_t generation = 0;
    };

    std::vector<Slot> slots_;
    std::unique_ptr<std::uint8_t[]> arena_;  ///< not cleared: surfaces are written before they are read
    std::size_t arena_bytes_, used_bytes_ = 0;
    std::uint32_t generation_ = 1;
};

}  // namespace oblong
