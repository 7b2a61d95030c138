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

    /// Becomes what both sets have; tells whether that holds anything that `known` does not.
    bool set_common(const BitSet& a, const BitSet& b, const BitSet& known) {
        std::uint64_t news = 0;
        for (std::size_t i = 0; i < words_.size(); ++i) {
            words_[i] = a.words_[i] & b.words_[i];
            news |= words_[i] & ~known.words_[i];
        }
        return news != 0;
    }

    int count() const {
        int sum = 0;
        for (const std::uint64_t word : words_) sum += std::popcount(word);
        return sum;
    }

  private:
    std::vector<std::uint64_t> words_;
};

}  // namespace oblong::map
