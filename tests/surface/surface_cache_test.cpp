#include "engine/surface/surface_cache.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/random.h"

namespace oblong::test {
namespace {

using Texels = std::vector<std::uint8_t>;

/// Whether the cache has a slot's surface, of 40 bytes. Asking for it brings it in.
bool has(SurfaceCache& cache, std::size_t slot) {
    return cache.get(slot, 40, {}).is_valid;
}

/// Shows some surfaces of 40 bytes in a frame of their own.
void show(SurfaceCache& cache, std::initializer_list<std::size_t> slots) {
    cache.start_frame();
    for (const std::size_t slot : slots) cache.get(slot, 40, {});
}

TEST(SurfaceCache, KeepsWhileValid) {
    SurfaceCache cache(4, 100, 100);
    EXPECT_FALSE(cache.get(0, 40, {1}).is_valid);
    EXPECT_TRUE(cache.get(0, 40, {1}).is_valid);
    EXPECT_FALSE(cache.get(0, 40, {2}).is_valid) << "the light has changed";
    EXPECT_TRUE(cache.get(0, 40, {2}).is_valid);
    cache.start_frame();
    EXPECT_TRUE(cache.get(0, 40, {2}).is_valid);
    cache.clear();
    EXPECT_EQ(cache.used_bytes(), 0u);
    EXPECT_FALSE(cache.get(0, 40, {2}).is_valid);
}

TEST(SurfaceCache, EachPartOfTheKeyCounts) {
    SurfaceCache cache(1, 100, 100);
    const SurfaceKey key{1, 2, 3};
    cache.get(0, 10, key);
    for (const SurfaceKey& other : {SurfaceKey{9, 2, 3}, SurfaceKey{1, 9, 3}, SurfaceKey{1, 2, 9}}) {
        EXPECT_TRUE(cache.get(0, 10, key).is_valid);
        EXPECT_FALSE(cache.get(0, 10, other).is_valid);
        EXPECT_FALSE(cache.get(0, 10, key).is_valid) << "only the last one is kept";
    }
}

TEST(SurfaceCache, TheOldestMakesRoom) {
    SurfaceCache cache(9, 125, 125);
    for (const std::size_t slot : {0, 1, 2}) show(cache, {slot});
    show(cache, {});
    show(cache, {3});
    EXPECT_EQ(cache.evicted_surfaces(), 1);
    EXPECT_EQ(cache.used_bytes(), 120u);
    for (const std::size_t slot : {1, 2, 3}) EXPECT_TRUE(has(cache, slot)) << slot;
    EXPECT_EQ(cache.arena_bytes(), 125u);
}

TEST(SurfaceCache, WhatTheLastFrameShowedStaysIfOthersCanGo) {
    SurfaceCache cache(9, 125, 125);
    show(cache, {0, 1, 2});
    show(cache, {0});
    show(cache, {3});
    EXPECT_TRUE(has(cache, 0)) << "older than 1 in memory, but shown since";
    show(cache, {0, 3});
    show(cache, {4, 5});
    EXPECT_EQ(cache.arena_bytes(), 125u) << "the last frame's go where there is no other room";
    EXPECT_EQ(cache.evicted_surfaces(), 3);
}

TEST(SurfaceCache, GrowsWhereOneFrameNeedsMore) {
    SurfaceCache cache(9, 100, 100);
    show(cache, {0, 1, 2, 3, 4, 5});
    EXPECT_EQ(cache.arena_bytes(), 300u);
    EXPECT_EQ(cache.evicted_surfaces(), 0);
    show(cache, {6});
    EXPECT_EQ(cache.arena_bytes(), 300u) << "20 bytes are left in each piece, and no more";
    EXPECT_EQ(cache.evicted_surfaces(), 1);
    EXPECT_FALSE(cache.get(8, 1000, {}).is_valid);
    EXPECT_EQ(cache.arena_bytes(), 1300u) << "a piece is as large as the surface that it is for";
}

TEST(SurfaceCache, AnotherKeyInTheSameFrameGetsOtherTexels) {
    SurfaceCache cache(1, 100, 100);
    std::uint8_t* const first = cache.get(0, 40, {1}).texels;
    std::uint8_t* const second = cache.get(0, 40, {2}).texels;
    EXPECT_GE(std::abs(first - second), 40);
    EXPECT_EQ(cache.used_bytes(), 40u);
    cache.start_frame();
    EXPECT_EQ(cache.get(0, 40, {3}).texels, second) << "in the next frame it is overwritten";
}

/// A map that forgets nothing beside the cache: what is valid is what was written last, and what a frame has got stays
/// to its end.
class CacheBesideMap {
  public:
    CacheBesideMap(std::size_t piece_bytes, std::uint32_t seed)
        : random_(seed), cache_(kSlots, piece_bytes, piece_bytes) {
        for (std::size_t& bytes : bytes_of_) bytes = 1 + random_() % (random_() % 4 == 0 ? piece_bytes : 30);
    }

    void draw_frame() {
        if (random_() % 50 == 0) cache_.clear();
        cache_.start_frame();
        shown_.clear();
        for (auto left = random_() % 40; left > 0; --left) get_any();
        for (const Shown& shown : shown_)
            ASSERT_TRUE(std::equal(shown.texels.begin(), shown.texels.end(), shown.at)) << "overwritten in its frame";
        ASSERT_LE(cache_.used_bytes(), cache_.arena_bytes());
    }
    const SurfaceCache& cache() const { return cache_; }
    int found = 0;

  private:
    static constexpr std::size_t kSlots = 60;
    struct Shown {
        const std::uint8_t* at;
        Texels texels;
    };
    struct Written {
        SurfaceKey key;
        Texels texels;
    };

    void get_any() {
        // Mostly the same few slots: what is never asked for again can't be found.
        const std::size_t slot = random_() % (random_() % 3 == 0 ? kSlots : 8), bytes = bytes_of_[slot];
        const SurfaceKey key{random_() % 8 == 0, 0, 0};
        const SurfaceCache::Found got = cache_.get(slot, bytes, key);
        Written& written = written_[slot];
        if (got.is_valid) {
            ++found;
            ASSERT_EQ(written.key, key);
            ASSERT_EQ(Texels(got.texels, got.texels + bytes), written.texels);
        } else {
            written = {key, Texels(bytes)};
            fill_at_random(written.texels, random_);
            std::copy(written.texels.begin(), written.texels.end(), got.texels);
        }
        shown_.push_back({got.texels, written.texels});
    }

    std::mt19937 random_;
    std::array<std::size_t, kSlots> bytes_of_{};
    SurfaceCache cache_;
    std::map<std::size_t, Written> written_;
    std::vector<Shown> shown_;
};

TEST(SurfaceCache, NothingIsStaleAndNothingMovesInAFrame) {
    for (const std::size_t piece_bytes : {50, 300, 1000, 4000}) {
        CacheBesideMap pair(piece_bytes, static_cast<std::uint32_t>(piece_bytes));
        for (int frame = 0; frame < 2000; ++frame) pair.draw_frame();
        EXPECT_GT(pair.found, 2000) << piece_bytes;
        EXPECT_GT(pair.cache().evicted_surfaces(), 1000) << piece_bytes;
        EXPECT_LT(pair.cache().arena_bytes(), 20 * piece_bytes + 40 * 300) << "it grew without need";
    }
}

}  // namespace
}  // namespace oblong::test
