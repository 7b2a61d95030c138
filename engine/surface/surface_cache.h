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

/// Lit surfaces, kept while they are valid and there is room. One slot for each face and mip level; the texels lie in
/// an arena that is used as a ring, as Quake's: a rover goes round, and a new surface takes the place of what it meets,
/// the oldest. It passes by what this frame or the last one asked for, so texels got in a frame stay where they are,
/// unchanged, until the next start_frame(). A frame that needs more than the arena makes it grow, for good. Caching
/// never changes a picture: a rebuilt surface is the same.
class SurfaceCache {
  public:
    /// The arena grows by pieces of this size (or of a larger surface's); both numbers below 2^32.
    SurfaceCache(std::size_t slot_count, std::size_t piece_bytes);

    struct Found {
        std::uint8_t* texels;
        bool is_valid;  ///< false: the caller must write them
    };

    /// From here on, texels got before may be overwritten.
    void start_frame() { ++frame_; }
    /// The texels of a slot, `bytes` of them (at least one, for a slot always as many), made of what `key` says.
    Found get(std::size_t slot, std::size_t bytes, const SurfaceKey& key);
    /// Forgets all surfaces, those of this frame too.
    void clear();

    std::size_t used_bytes() const { return used_bytes_; }  ///< of arena_bytes()
    std::size_t arena_bytes() const { return arena_bytes_; }
    /// What it takes, used or not.
    std::size_t bytes() const;
    /// How many surfaces have made room for others.
    std::int64_t evicted_surfaces() const { return evicted_surfaces_; }

  private:
    using BlockIndex = std::uint32_t;
    static constexpr std::uint32_t kNone = ~std::uint32_t{0};

    /// Consecutive bytes of the arena, used by a surface or free. Each piece ends with a block without bytes, which is
    /// never freed: so blocks of two pieces are never joined.
    struct Block {
        SurfaceKey key;
        std::uint8_t* texels = nullptr;
        std::uint32_t bytes = 0;
        std::uint32_t slot = kNone;  ///< of its surface; none: it is free
        std::uint32_t frame = 0;     ///< that asked for it last
        BlockIndex next = 0;         ///< the one behind it in memory; the last one's: the first of the next piece
    };

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
    std::vector<BlockIndex> spare_;                        ///< entries of blocks_ that are no blocks now
    std::vector<std::unique_ptr<std::uint8_t[]>> pieces_;  ///< not cleared: surfaces are written before they are read
    BlockIndex rover_ = 0, last_ = kNone;                  ///< the last block of the last piece
    std::uint32_t frame_;
    std::uint32_t piece_bytes_;
    std::size_t arena_bytes_ = 0, used_bytes_ = 0;
    std::int64_t evicted_surfaces_ = 0;
};

}  // namespace oblong
