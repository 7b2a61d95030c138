#include "engine/visibility/span_buffer.h"

#include <gtest/gtest.h>

#include "tests/support/random.h"

namespace oblong::test {

namespace {

constexpr std::int32_t kWidth = 97, kHeight = 5;

/// A span that compares: row, first column, end.
using PixelRun = std::array<std::int32_t, 3>;

/// The obvious way: a flag a pixel, whether it is free.
class FreePixels {
  public:
    char& at(std::int32_t y, std::int32_t x) { return item(is_free_, y * kWidth + x); }
    /// The free pixels of row y's [first, end) as runs, added to `runs`; taken if `takes_them`.
    void find(std::int32_t y, std::int32_t first, std::int32_t end, bool takes_them, std::vector<PixelRun>& runs) {
        for (std::int32_t x = std::max(first, 0); x < std::min(end, kWidth); ++x) {
            if (!at(y, x)) continue;
            if (!runs.empty() && runs.back()[0] == y && runs.back()[2] == x)
                ++runs.back()[2];
            else
                runs.push_back({y, x, x + 1});
            if (takes_them) at(y, x) = false;
        }
    }
    bool is_full() const { return std::count(is_free_.begin(), is_free_.end(), true) == 0; }

  private:
    std::vector<char> is_free_ = std::vector<char>(kWidth * kHeight, true);
};

/// A buffer of the engine's, and the same by the obvious way.
struct Both {
    SpanBuffer span_buffer{kWidth, kHeight};
    FreePixels reference;
};

std::int32_t up_to(std::mt19937& random, std::int32_t most) {
    return random_below(random, most + 1);
}

std::vector<PixelRun> runs_of(const SpanList& list) {
    std::vector<PixelRun> runs;
    for (const Span& span : list) runs.push_back({span.y, span.first, span.end});
    return runs;
}

/// Columns of a few rows; some of them empty, or off the screen.
ScanlineExtents random_rows(std::mt19937& random, std::int32_t longest) {
    ScanlineExtents rows(kHeight);
    rows.first = up_to(random, kHeight - 1);
    rows.end = rows.first + up_to(random, kHeight - rows.first);
    for (std::int32_t y = rows.first; y < rows.end; ++y) {
        item(rows.left, y) = up_to(random, kWidth + 40) - 20;
        item(rows.right, y) = item(rows.left, y) + up_to(random, longest) - 1;
    }
    return rows;
}

std::vector<PixelRun> expected_runs(const ScanlineExtents& rows, bool takes_them, FreePixels& reference) {
    std::vector<PixelRun> runs;
    for (std::int32_t y = rows.first; y < rows.end; ++y)
        reference.find(y, item(rows.left, y), item(rows.right, y), takes_them, runs);
    return runs;
}

/// The rows from the first to the last that have a free pixel in one of the rectangle's columns.
PixelRange rows_with_free(const ScreenRectangle& rectangle, FreePixels& reference) {
    PixelRange rows{kHeight, 0};
    for (std::int32_t y = rectangle.first_row; y < rectangle.end_row; ++y) {
        std::vector<PixelRun> free;
        reference.find(y, rectangle.first_column, rectangle.end_column, false, free);
        if (!free.empty()) rows = {std::min(rows.first, y), y + 1};
    }
    return rows;
}

}  // namespace

TEST(SpanBuffer, GivesWhatWasFreeAndOnlyOnce) {
    std::mt19937 random(5);
    for (int trial = 0; trial < 2000; ++trial) {
        auto [span_buffer, reference] = Both();
        const std::int32_t longest = 1 << random() % 8;
        for (int claim = 0; claim < 60; ++claim) {
            const std::int32_t y = up_to(random, kHeight - 1), first = up_to(random, kWidth + 39) - 20;
            const std::int32_t end = first + up_to(random, longest);
            SpanList owned;
            span_buffer.claim(y, first, end, owned);
            std::vector<PixelRun> expected;
            reference.find(y, first, end, true, expected);
            ASSERT_EQ(runs_of(owned), expected);
            ASSERT_EQ(span_buffer.is_full(), reference.is_full());
        }
    }
}

TEST(SpanBuffer, GivesAFaceWhatIsFreeOfItsRows) {
    std::mt19937 random(6);
    for (int trial = 0; trial < 3000; ++trial) {
        auto [span_buffer, reference] = Both();
        SpanList owned;
        std::vector<PixelRun> expected;
        const std::int32_t longest = 1 << random() % 8;
        for (int claim = 0; claim < 60; ++claim) {
            const ScanlineExtents rows = random_rows(random, longest);
            const bool takes_them = random() % 4 != 0;
            if (takes_them)
                span_buffer.claim(rows, owned);
            else
                span_buffer.find_free(rows, owned);
            const std::vector<PixelRun> added = expected_runs(rows, takes_them, reference);
            expected.insert(expected.end(), added.begin(), added.end());
            ASSERT_EQ(owned.size(), expected.size());
            ASSERT_EQ(span_buffer.is_full(), reference.is_full());
        }
        ASSERT_EQ(runs_of(owned), expected);
    }
}

TEST(SpanBuffer, ContinuesFromAnyFreePixels) {
    std::mt19937 random(7);
    for (int trial = 0; trial < 2000; ++trial) {
        auto [span_buffer, reference] = Both();
        std::vector<Span> free;
        const std::int32_t most_between = up_to(random, 20);
        for (std::int32_t y = 0; y < kHeight; ++y)
            for (std::int32_t x = 0; x < kWidth; ++x) {
                reference.at(y, x) = up_to(random, most_between) == 0;
                if (reference.at(y, x)) free.push_back({y, x, x + 1});  // not joined to its neighbours
            }
        span_buffer.reset_to(free);
        ASSERT_EQ(span_buffer.is_full(), reference.is_full());
        for (int claim = 0; claim < 20; ++claim) {
            const ScanlineExtents rows = random_rows(random, 64);
            SpanList owned;
            span_buffer.claim(rows, owned);
            ASSERT_EQ(runs_of(owned), expected_runs(rows, true, reference));
        }
        SpanList rest;
        span_buffer.claim_rest(rest);
        std::vector<PixelRun> expected;
        for (std::int32_t y = 0; y < kHeight; ++y) reference.find(y, 0, kWidth, true, expected);
        ASSERT_EQ(runs_of(rest), expected);
    }
}

TEST(SpanBuffer, KnowsWhetherARectangleHasAFreePixel) {
    std::mt19937 random(8);
    int full = 0, free = 0;
    for (int trial = 0; trial < 1000; ++trial) {
        auto [span_buffer, reference] = Both();
        for (int claim = 0; claim < 20; ++claim) {
            const ScanlineExtents taken = random_rows(random, 97);
            SpanList owned;
            span_buffer.claim(taken, owned);
            expected_runs(taken, true, reference);
            const std::int32_t column = up_to(random, kWidth + 10) - 10, row = up_to(random, kHeight);
            const ScreenRectangle rectangle{column, column + 1 + up_to(random, 39), row,
                                            row + up_to(random, kHeight - row)};
            const PixelRange found = span_buffer.rows_with_free(rectangle),
                             needed = rows_with_free(rectangle, reference);
            const bool is_free = needed.first < needed.end;
            ASSERT_EQ(span_buffer.has_free(rectangle), is_free);
            ASSERT_EQ(found.first < found.end, is_free);
            if (!is_free) {
                ++full;
                continue;
            }
            ASSERT_EQ(found.first, needed.first);
            ASSERT_EQ(found.end, needed.end);
            ++free;
        }
    }
    EXPECT_GT(full, 1000);
    EXPECT_GT(free, 1000);
}

TEST(SpanBuffer, EverySecondPixelFreeIsTheMostIntervals) {
    SpanBuffer span_buffer(kWidth, kHeight);
    SpanList owned;
    for (std::int32_t y = 0; y < kHeight; ++y)
        for (std::int32_t x = 1; x < kWidth; x += 2) span_buffer.claim(y, x, x + 1, owned);
    SpanList row, rest;
    span_buffer.claim(2, 0, kWidth, row);
    EXPECT_EQ(row.size(), 49u);
    span_buffer.claim_rest(rest);
    EXPECT_EQ(rest.size(), 49u * (kHeight - 1));
    EXPECT_TRUE(span_buffer.is_full());
}

}  // namespace oblong::test
