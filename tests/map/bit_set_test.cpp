#include "tools/map/vis/bit_set.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>
#include <set>

#include "tests/support/random.h"

namespace oblong::test::bit_set_test {
namespace {

constexpr int kSize = 300;

std::set<std::size_t> random_numbers(std::mt19937& random, int count) {
    std::set<std::size_t> numbers;
    for (int i = 0; i < count; ++i) numbers.insert(static_cast<std::size_t>(random_below(random, kSize)));
    return numbers;
}

map::BitSet bits_of(const std::set<std::size_t>& numbers) {
    map::BitSet bits(kSize);
    for (const std::size_t number : numbers) bits.add(number);
    return bits;
}

std::set<std::size_t> common(const std::set<std::size_t>& a, const std::set<std::size_t>& b) {
    std::set<std::size_t> both;
    std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
    return both;
}

std::set<std::size_t> numbers_of(const map::ThinSet& set) {
    std::set<std::size_t> numbers;
    for (std::size_t i = 0; i < kSize; ++i)
        if (set.has(i)) numbers.insert(i);
    return numbers;
}

// Used again and again, as along chains of portals: nothing stays of what was in it before.
TEST(ThinSet, IsTheIntersectionEachTimeItIsUsed) {
    std::mt19937 random(4);
    map::ThinSet first(kSize), second(kSize), third(kSize);
    int with_news = 0;
    for (int trial = 0; trial < 500; ++trial) {
        const auto all = random_numbers(random, random_below(random, 60)), a = random_numbers(random, 200),
                   b = random_numbers(random, 40), known = random_numbers(random, 500);
        first.set(bits_of(all));
        EXPECT_EQ(numbers_of(first), all);
        const auto seen = common(all, a), both = common(seen, b);
        second.set_common(first, bits_of(a), bits_of({}));
        EXPECT_EQ(numbers_of(second), seen);
        const bool has_news = third.set_common(second, bits_of(b), bits_of(known));
        EXPECT_EQ(numbers_of(third), both);
        EXPECT_EQ(has_news, !std::includes(known.begin(), known.end(), both.begin(), both.end()));
        with_news += has_news ? 1 : 0;
    }
    EXPECT_GT(with_news, 100);
    EXPECT_LT(with_news, 400);
}

}  // namespace
}  // namespace oblong::test::bit_set_test
