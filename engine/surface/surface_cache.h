#pragma once

#include <cstdint>
#include <memory>
#include <vector>

namespace oblong {

/// What the texels of a surface were made of, beside what never changes.
struct SurfaceKey {
    std::uint64_t light = 0;          ///< the brightness of the face's styles, packed
    std::int32_t texture = 0;         ///< that an animated one shows; -1: the face's own
    std::uint32_t moving_lights = 0;  ///< a number of those that touch it, where they are; 0: none
    bool operator==(const SurfaceKey&) const = default;
};

/// Lit surfaces, kept while they are valid. One slot for each face and mip level; the texels lie in one arena that is
/// filled from the start and emptied when it is full. Caching never changes a picture: a rebuilt surface is the same.
class SurfaceCache {
  public:
    /// At most 2^32 - 1 bytes.
    SurfaceCache(std::size_t slot_count, std::size_t arena_bytes)
        : slots_(slot_count), arena_(new std::uint8_t[arena_bytes]), arena_bytes_(arena_bytes) {}

    struct Found {
        std::uint8_t* texels;
        bool is_valid;  ///< false: the caller must write them
    };

    /// The texels of a slot, `bytes` of them (at most the arena's size), made of what `key` says. Texels got before may
    /// be overwritten: use them before the next call.
    Found get(std::size_t slot, std::size_t bytes, const SurfaceKey& key);

    std::size_t used_bytes() const { return used_bytes_; }  ///< of arena_bytes()
    std::size_t arena_bytes() const { return arena_bytes_; }
    /// What it takes, used or not.
    std::size_t bytes() const { return arena_bytes_ + slots_.size() * sizeof(Slot); }
    /// How often all surfaces were forgotten, because the arena was full or by clear().
    std::uint32_t times_emptied() const { return generation_ - 1; }

    /// Forgets all surfaces.
    void clear() {
        used_bytes_ = 0;
        ++generation_;
    }

  private:
    struct Slot {
        SurfaceKey key;
        std::uint32_t offset = 0;
        std::uint32_t generation = 0;
    };

    std::vector<Slot> slots_;
    std::unique_ptr<std::uint8_t[]> arena_;  ///< not cleared: surfaces are written before they are read
    std::size_t arena_bytes_, used_bytes_ = 0;
    std::uint32_t generation_ = 1;
};

}  // namespace oblong
