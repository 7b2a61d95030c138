#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>
#include <vector>

#include "engine/base/table.h"

namespace oblong {

/// The changing inputs of a surface's texels.
struct SurfaceKey {
    std::uint64_t light = 0;          ///< the brightness of the face's styles, packed
    std::int32_t texture = 0;         ///< the frame of an animated texture; -1: the face's own texture
    std::uint32_t moving_lights = 0;  ///< LightTouch::version; 0: none
    bool operator==(const SurfaceKey&) const = default;
};

/// A cache of lit surfaces, with one slot for each face and mip level. The texels are in an arena used as a ring, as in
/// Quake: a new surface replaces the oldest ones, at the rover. Surfaces used in this frame or the last are skipped, so
/// texels returned in a frame stay unchanged until the next start_frame(). If a frame needs more than the arena, it
/// grows permanently. Caching never changes a picture: a rebuilt surface is the same.
class SurfaceCache {
  public:
    /// The arena begins with a piece of the first size, and grows by pieces of the second (or of a larger surface's
    /// size). Both are below 2^32.
    SurfaceCache(std::size_t slot_count, std::size_t first_bytes, std::size_t piece_bytes);

    struct Found {
        std::uint8_t* texels;
        bool is_valid;  ///< false: the caller has to write them
    };

    /// Texels returned earlier may be overwritten from now on.
    void start_frame() { ++frame_; }
    /// The `bytes` texels of a slot (at least one, constant for a slot) for the inputs in `key`.
    Found get(std::size_t slot, std::size_t bytes, const SurfaceKey& key);
    /// Drops all surfaces, including those of this frame.
    void clear();

    std::size_t used_bytes() const { return used_bytes_; }  ///< of arena_bytes()
    std::size_t arena_bytes() const { return arena_bytes_; }
    /// Memory of the cache, used or not.
    std::size_t bytes() const;
    /// How many surfaces were evicted for others.
    std::int64_t evicted_surfaces() const { return evicted_surfaces_; }

  private:
    using BlockIndex = std::make_unsigned_t<LevelNumber>;
    static constexpr BlockIndex kNone = std::numeric_limits<BlockIndex>::max();

    /// Consecutive bytes of the arena, used by a surface or free. Each piece ends with a block of 0 bytes, which is
    /// never freed, so blocks of two pieces are never joined.
    struct Block {
        SurfaceKey key;
        std::uint8_t* texels = nullptr;
        std::uint32_t bytes = 0;
        std::uint32_t slot = kFree;  ///< of its surface
        std::uint32_t frame = 0;     ///< that used it last
        BlockIndex next = 0;         ///< next in memory; after the last of a piece, the first of the next piece
    };

    static constexpr std::uint32_t kFree = ~std::uint32_t{0};

    BlockIndex allocate(std::uint32_t bytes);
    BlockIndex find_room(std::uint32_t bytes, std::uint32_t frames_kept) const;
    void gather(BlockIndex first, std::uint32_t bytes);
    void evict(Block& block);
    void forget(Block& block);
    void grow(std::uint32_t bytes);
    Block free_block(std::uint8_t* texels, std::uint32_t bytes, BlockIndex next) const;
    BlockIndex add_block(const Block& block);

    std::vector<BlockIndex> block_of_slot_;
    std::vector<Block> blocks_;
    std::vector<BlockIndex> spare_;                        ///< unused entries of blocks_
    std::vector<std::unique_ptr<std::uint8_t[]>> pieces_;  ///< uninitialised: surfaces are written before they are read
    BlockIndex rover_ = 0, last_ = kNone;                  ///< `last_`: the last block of the last piece
    std::uint32_t frame_;
    std::uint32_t piece_bytes_;
    std::size_t arena_bytes_ = 0, used_bytes_ = 0;
    std::int64_t evicted_surfaces_ = 0;
};

}  // namespace oblong
