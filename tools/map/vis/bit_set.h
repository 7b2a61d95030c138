#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace oblong::map {

/// A set of small numbers, for fast unions and intersections of sets of one size.
class BitSet {
  public:
    explicit BitSet(std::size_t size = 0) : words_((size + 63) / 64, 0) {}

    bool has(std::size_t i) const { return (words_[i / 64] >> (i % 64) & 1) != 0; }
    void add(std::size_t i) { words_[i / 64] |= std::uint64_t{1} << (i % 64); }
    void remove(std::size_t i) { words_[i / 64] &= ~(std::uint64_t{1} << (i % 64)); }

    void add_all(const BitSet& other) {
        for (std::size_t i = 0; i < words_.size(); ++i) words_[i] |= other.words_[i];
    }

    /// Calls use(i) for each i in this set but not in `other`, in ascending order. use(i) may remove i.
    template <class Use>
    void for_each_beyond(const BitSet& other, Use use) const {
        for (std::size_t i = 0; i < words_.size(); ++i)
            for (std::uint64_t rest = words_[i] & ~other.words_[i]; rest != 0; rest &= rest - 1)
                use(64 * i + static_cast<std::size_t>(std::countr_zero(rest)));
    }

    template <class Use>
    void for_each(Use use) const {
        for_each_beyond(BitSet(64 * words_.size()), use);
    }

    /// Elements 8 i to 8 i + 7, the first in the lowest bit.
    std::uint8_t byte(std::size_t i) const { return static_cast<std::uint8_t>(words_[i / 8] >> (i % 8 * 8)); }
    /// Adds them; none of them may be in the set.
    void add_byte(std::size_t i, std::uint8_t byte) { words_[i / 8] |= std::uint64_t{byte} << (i % 8 * 8); }

    bool operator==(const BitSet&) const = default;

    int count() const {
        int sum = 0;
        for (const std::uint64_t word : words_) sum += std::popcount(word);
        return sum;
    }

  private:
    friend class ThinSet;
    std::vector<std::uint64_t> words_;
};

/// A sparse set, such as the portals visible at the end of a chain of portals: only visits words that are not 0, 6 of
/// 100 there.
class ThinSet {
  public:
    explicit ThinSet(std::size_t size) : bits_(size), held_(bits_.words_.size(), 0) {}

    bool has(std::size_t i) const { return bits_.has(i); }

    void set(const BitSet& all) {
        bits_ = all;
        held_count_ = 0;
        for (std::size_t i = 0; i < held_.size(); ++i)
            if (all.words_[i] != 0) held_[held_count_++] = i;
    }

    /// Becomes the intersection of two other sets; returns whether it has elements outside of `known`.
    bool set_common(const ThinSet& a, const BitSet& b, const BitSet& known) {
        for (std::size_t k = 0; k < held_count_; ++k) bits_.words_[held_[k]] = 0;
        held_count_ = 0;
        std::uint64_t news = 0;
        for (std::size_t k = 0; k < a.held_count_; ++k) {
            const std::size_t i = a.held_[k];
            const std::uint64_t common = a.bits_.words_[i] & b.words_[i];
            bits_.words_[i] = common;
            held_[held_count_] = i;
            held_count_ += common != 0 ? 1u : 0u;
            news |= common & ~known.words_[i];
        }
        return news != 0;
    }

  private:
    BitSet bits_;
    std::vector<std::size_t> held_;  // the first held_count_: of words that are not 0
    std::size_t held_count_ = 0;
};

}  // namespace oblong::map
