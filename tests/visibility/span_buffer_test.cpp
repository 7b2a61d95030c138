#include "engine/visibility/span_buffer.h"

#include <gtest/gtest.h>

#include <random>

namespace oblong::test {

namespace {

constexpr std::int32_t kWidth = 97, kHeight = 5;

/// The obvious way: a flag a pixel.
class FlagCoverage {
  public:
    std::vector<bool> claim(std::int32_t y, std::int32_t first, std::int32_t end) {
        std::vector<bool> owned(kWidth);
        for (std::int32_t x = std::max(first, 0); x < std::min(end, kWidth); ++x) {
            const auto pixel = static_cast<std::size_t>(y * kWidth + x);
            owned[static_cast<std::size_t>(x)] = !taken_[pixel];
            taken_[pixel] = true;
        }
        return owned;
    }
    bool is_full() const { return std::find(taken_.begin(), taken_.end(), false) == taken_.end(); }

  private:
    std::vector<bool> taken_ = std::vector<bool>(kWidth * kHeight);
};

std::vector<bool> flags_of(const std::vector<Span>& spans, std::int32_t y) {
    std::vector<bool> flags(kWidth);
    for (const Span& span : spans) {
        EXPECT_EQ(span.y, y);
        EXPECT_LT(span.first, span.end);
        for (std::int32_t x = span.first; x < span.end; ++x) {
            EXPECT_FALSE(flags[static_cast<std::size_t>(x)]) << "a pixel twice in one claim";
            flags[static_cast<std::size_t>(x)] = true;
        }
    }
    return flags;
}

}  // namespace

TEST(SpanBuffer, GivesWhatWasFreeAndOnlyOnce) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 2000; ++trial) {
        SpanBuffer span_buffer(kWidth, kHeight);
        FlagCoverage reference;
        const std::int32_t longest = 1 << random() % 8;
        for (int claim = 0; claim < 60; ++claim) {
            const auto y = static_cast<std::int32_t>(random() % kHeight);
            const auto first = static_cast<std::int32_t>(random() % (kWidth + 40)) - 20;
            const auto end = first + static_cast<std::int32_t>(random() % static_cast<std::uint32_t>(longest + 1));
            std::vector<Span> owned;
            span_buffer.claim(y, first, end, owned);
            ASSERT_EQ(flags_of(owned, y), reference.claim(y, first, end));
            ASSERT_EQ(span_buffer.is_full(), reference.is_full());
        }
    }
}

TEST(SpanBuffer, EverySecondPixelFreeIsTheMostIntervals) {
    SpanBuffer span_buffer(kWidth, kHeight);
    std::vector<Span> owned;
    for (std::int32_t x = 1; x < kWidth; x += 2) span_buffer.claim(2, x, x + 1, owned);
    owned.clear();
    span_buffer.claim(2, 0, kWidth, owned);
    EXPECT_EQ(owned.size(), 49u);
}

TEST(SpanBuffer, TheRestIsAllThatIsLeft) {
    SpanBuffer span_buffer(kWidth, kHeight);
    std::vector<Span> owned, rest;
    span_buffer.claim(0, 10, 20, owned);
    span_buffer.claim_rest(rest);
    std::int64_t pixels = 0;
    for (const Span& span : rest) pixels += span.end - span.first;
    EXPECT_EQ(pixels, kWidth * kHeight - 10);
    EXPECT_TRUE(span_buffer.is_full());
    span_buffer.reset();
    EXPECT_FALSE(span_buffer.is_full());
}

}  // namespace oblong::test
