#pragma once

#include "engine/fixed/arithmetic.h"
#include "engine/fixed/fixed.h"

namespace oblong {

/// Multiplies numbers by part / whole, from 0 to 1, with one division for all.
///
/// The quotient has 30 bits. A product with it is off by at most 2^33 * 3 * 2^-30 + 1 = 25, mostly by 0; its remainder,
/// exact in 64 bits, gives the correction.
template <class Number>
class Share {
  public:
    /// 0 <= part <= whole, whole > 0.
    constexpr Share(Number part, Number whole) : part_(part.raw), whole_(whole.raw) {
        const int drop = std::max(log2_floor(whole) - 31, 0);
        ratio_30_ = ((part_ >> drop) << kBits) / (whole_ >> drop);
    }

    /// size * part / whole rounded to nearest, ties up, as by mul_div().
    constexpr std::int64_t of(std::int64_t size) const {
        if (whole_ > kLargestWhole || detail::magnitude(size) > kLargestSize) return mul_div(size, part_, whole_);
        std::int64_t share = floor_shift(size * ratio_30_, kBits);
        std::int64_t rest = rest_of(size, share);
        for (; rest < 0; rest += whole_) --share;
        for (; rest >= whole_; rest -= whole_) ++share;
        return share + (rest >= whole_ - rest);
    }

  private:
    static constexpr int kBits = 30;
    static constexpr std::int64_t kLargestWhole = std::int64_t{1} << 57;
    static constexpr std::uint64_t kLargestSize = std::uint64_t{1} << 33;

    /// size * part - share * whole; the products may overflow, their difference does not.
    constexpr std::int64_t rest_of(std::int64_t size, std::int64_t share) const {
        const auto product = [](std::int64_t a, std::int64_t b) {
            return static_cast<std::uint64_t>(a) * static_cast<std::uint64_t>(b);
        };
        return static_cast<std::int64_t>(product(size, part_) - product(share, whole_));
    }

    std::int64_t part_, whole_, ratio_30_;
};

}  // namespace oblong
