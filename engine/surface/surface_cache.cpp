#include "engine/surface/surface_cache.h"

#include <algorithm>
#include <new>

namespace oblong {

namespace {

/// How many frames surfaces are kept if possible, and always. Most surfaces of the last frame are used again.
constexpr std::uint32_t kFramesKept = 2, kFramesHeld = 1;

/// There is room for blocks of this size at first: levels with smaller surfaces need more.
constexpr std::size_t kUsualBlockBytes = 640;

}  // namespace

SurfaceCache::SurfaceCache(std::size_t slot_count, std::size_t first_bytes, std::size_t piece_bytes)
    : block_of_slot_(slot_count, kNone), frame_(kFramesKept), piece_bytes_(static_cast<std::uint32_t>(piece_bytes)) {
    blocks_.reserve(first_bytes / kUsualBlockBytes);
    grow(static_cast<std::uint32_t>(first_bytes));
    // The system gives memory when it is first written: not in a frame.
    std::fill_n(pieces_.front().get(), arena_bytes_, std::uint8_t{0});
}

SurfaceCache::Found SurfaceCache::get(std::size_t slot, std::size_t bytes, const SurfaceKey& key) {
    const BlockIndex known = block_of_slot_[slot];
    if (known != kNone) {
        Block& block = blocks_[known];
        const bool is_valid = block.key == key, is_of_this_frame = block.frame == frame_;
        if (is_valid || !is_of_this_frame) {
            if (!is_valid) block.key = key;
            block.frame = frame_;
            return {block.texels, is_valid};
        }
        forget(block);  // its texels stay to the end of the frame
    }
    const BlockIndex index = allocate(static_cast<std::uint32_t>(bytes));
    Block& block = blocks_[index];
    block.key = key;
    block.slot = static_cast<std::uint32_t>(slot);
    block.frame = frame_;
    block_of_slot_[slot] = index;
    used_bytes_ += bytes;
    return {block.texels, false};
}

void SurfaceCache::clear() {
    for (Block& block : blocks_) forget(block);
    frame_ += kFramesKept;
}

std::size_t SurfaceCache::bytes() const {
    return arena_bytes_ + blocks_.capacity() * sizeof(Block) +
           (block_of_slot_.capacity() + spare_.capacity()) * sizeof(BlockIndex);
}

/// A free block of this size.
SurfaceCache::BlockIndex SurfaceCache::allocate(std::uint32_t bytes) {
    BlockIndex first = find_room(bytes, kFramesKept);
    if (first == kNone) first = find_room(bytes, kFramesHeld);
    if (first == kNone) {
        grow(bytes);
        first = rover_;
    }
    gather(first, bytes);
    rover_ = blocks_[first].next;
    return first;
}

/// The first of the consecutive blocks, nearest to the rover, that may be evicted and have this many bytes together; or
/// kNone.
SurfaceCache::BlockIndex SurfaceCache::find_room(std::uint32_t bytes, std::uint32_t frames_kept) const {
    BlockIndex first = rover_;
    std::uint32_t room = 0;
    std::size_t left = 2 * (blocks_.size() - spare_.size());  // two rounds, as they may begin before the rover
    for (BlockIndex index = rover_; left > 0; --left) {
        const Block& block = blocks_[index];
        index = block.next;
        const bool makes_room = block.bytes != 0 && frame_ - block.frame >= frames_kept;
        room = makes_room ? room + block.bytes : 0;
        if (room >= bytes) return first;
        if (room == 0) first = index;
    }
    return kNone;
}

/// Joins a block with those behind it until it has this many bytes. The rest becomes a separate block.
void SurfaceCache::gather(BlockIndex first, std::uint32_t bytes) {
    evict(blocks_[first]);
    Block whole = blocks_[first];
    while (whole.bytes < bytes) {
        Block& next = blocks_[whole.next];
        evict(next);
        spare_.push_back(whole.next);
        whole.bytes += next.bytes;
        whole.next = next.next;
    }
    if (whole.bytes > bytes) {
        const std::uint32_t rest = whole.bytes - bytes;
        whole.bytes = bytes;
        whole.next = add_block(free_block(whole.texels + bytes, rest, whole.next));
    }
    blocks_[first] = whole;
}

void SurfaceCache::evict(Block& block) {
    if (block.slot != kFree) ++evicted_surfaces_;
    forget(block);
}

void SurfaceCache::forget(Block& block) {
    if (block.slot == kFree) return;
    block_of_slot_[block.slot] = kNone;
    block.slot = kFree;
    used_bytes_ -= block.bytes;
}

/// Adds a piece with room for this many bytes, and moves the rover there.
void SurfaceCache::grow(std::uint32_t bytes) {
    const std::uint32_t piece_bytes = std::max(bytes, piece_bytes_);
    pieces_.emplace_back(new std::uint8_t[piece_bytes]);
    arena_bytes_ += piece_bytes;
    const BlockIndex end = add_block(free_block(nullptr, 0, 0));
    rover_ = add_block(free_block(pieces_.back().get(), piece_bytes, end));
    blocks_[end].next = last_ == kNone ? rover_ : blocks_[last_].next;
    if (last_ != kNone) blocks_[last_].next = rover_;
    last_ = end;
}

SurfaceCache::Block SurfaceCache::free_block(std::uint8_t* texels, std::uint32_t bytes, BlockIndex next) const {
    return {{}, texels, bytes, kFree, frame_ - kFramesKept, next};
}

SurfaceCache::BlockIndex SurfaceCache::add_block(const Block& block) {
    if (spare_.empty()) {
        if (blocks_.size() == kNone) throw std::bad_alloc();  // all indices are used; small memory has few
        if (blocks_.size() == blocks_.capacity()) blocks_.reserve(blocks_.size() + blocks_.size() / 4 + 64);
        blocks_.push_back(block);
        return static_cast<BlockIndex>(blocks_.size() - 1);
    }
    const BlockIndex index = spare_.back();
    spare_.pop_back();
    blocks_[index] = block;
    return index;
}

}  // namespace oblong
