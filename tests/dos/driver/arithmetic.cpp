// Prints a hash of divisions, products, projections, texels and their steps of numbers of every length: the same on
// every machine, whatever instructions it has for them.
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <random>

#include "engine/base/checksum.h"
#include "engine/fixed/wide.h"
#include "engine/raster/block_steps.h"
#include "engine/raster/perspective.h"
#include "engine/view/projection.h"

namespace {

using namespace oblong;

class Results {
  public:
    template <class Int>
    void add(Int number) {
        for (std::size_t byte = 0; byte < sizeof(Int); ++byte)
            hash_.add(static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> (8 * byte)));
    }
    std::uint64_t hash() const { return hash_.value(); }

  private:
    Fnv1a hash_;
};

template <PerspectiveRange Range>
void add_texel(Results& results, std::int64_t depth, std::int64_t over_z) {
    const auto add = [&](auto reciprocal) {
        const Depth<decltype(reciprocal), Range> at(InverseZ::from_raw(depth), reciprocal);
        results.add(at.times(TexelOverZ::from_raw(over_z), Texel::from_raw(40), Texel::from_raw(0xffff0000)));
    };
    add(DividedReciprocal{});
    for (const ReciprocalMethod method : kReciprocalMethods) add(TabledReciprocal{method});
}

/// What a block of texels is made of: `depth` is 1/z, `over_z` u/z.
void add_block(Results& results, std::int64_t depth, std::int64_t over_z, std::uint64_t bits) {
    results.add(DividedReciprocal::of(depth, std::countl_zero(static_cast<std::uint64_t>(depth)) - 4));
    // Below 65,536 texels, as where the range fits; all that is below 0 is clamped.
    const std::int64_t fitting = std::clamp(depth, kLeastFittingInverseZ.raw, kGreatestInverseZ.raw - 1);
    add_texel<PerspectiveRange::Fits>(results, fitting, over_z % (4 * depth));
    add_texel<PerspectiveRange::MayOverflow>(results, depth, over_z);
    const int size = static_cast<int>(bits % 32);
    const TexelPosition from{static_cast<std::uint32_t>(depth) >> size, static_cast<std::uint32_t>(over_z) >> size};
    const TexelPosition to{static_cast<std::uint32_t>(bits >> 32), static_cast<std::uint32_t>(bits >> 8) >> size};
    const auto count = static_cast<std::int32_t>(bits >> 40 & 0xfff) + 1;
    const auto columns = static_cast<std::uint32_t>(count);
    const InverseZ value = InverseZ::from_raw(depth), change = InverseZ::from_raw(over_z);
    results.add(stepped_in<PerspectiveRange::Fits>(value, change, columns).raw);
    results.add(stepped_in<PerspectiveRange::FitsWithShortSteps>(
                    value, InverseZ::from_raw(static_cast<std::int32_t>(over_z)), columns)
                    .raw);
    for (const TexelStep step : {steps_by_division(from, to, count), steps_by_division(to, from, 1),
                                 steps_by_shift(from, to, static_cast<int>(bits % 9))}) {
        results.add(step.u_16);
        results.add(step.v_16);
    }
}

/// The results of native code alone, where they have no number of their own above.
void add_native(Results& results, std::uint64_t a, std::uint64_t b, std::uint64_t c) {
    const auto a_32 = static_cast<std::uint32_t>(a), b_32 = static_cast<std::uint32_t>(b);
    const auto signed_a = static_cast<std::int32_t>(a >> 32), signed_b = static_cast<std::int32_t>(b >> 32);
    const int shift = static_cast<int>(c % 31) + 1;
    results.add(native::product_to_64(a_32, b_32));
    results.add(native::product_to_64(signed_a, signed_b));
    results.add(native::product_to_128(a, b).high);
    results.add(native::product_to_128(a, b).low);
    results.add(native::wrapping_sum(a, b, static_cast<std::uint32_t>(c)));
    results.add(native::shift_right({static_cast<std::int64_t>(a), b_32}, shift));
    results.add(native::shift_left(static_cast<std::int64_t>(a), shift).bits);
    results.add(std::int32_t{native::shift_left(static_cast<std::int64_t>(a), shift).is_below_zero});
    results.add(native::product_above_one(a_32, b_32));
    results.add(std::int32_t{native::is_in_range(a_32, b_32, static_cast<std::uint32_t>(c))});
    const std::uint32_t d = (b_32 >> 2 >> (c >> 40) % 24) + 1;
    const auto quotient_8 = static_cast<std::int64_t>(a % (std::uint64_t{d} << 33)) - (std::int64_t{d} << 32);
    const std::int32_t factor = static_cast<std::int32_t>(c & 0x3ffffff) + 1;
    results.add(native::rounded_quotient_8(
        static_cast<std::int32_t>(std::clamp<std::int64_t>(quotient_8 / factor, -0x7fffffff, 0x7fffffff)), factor, d));
    results.add(native::rounded_product_48(signed_a, static_cast<std::int32_t>(b), static_cast<std::int32_t>(c)));
}

}  // namespace

int main() {
    std::mt19937_64 random(1);
    Results results;
    const auto any_number = [&random] {
        const auto bits = static_cast<std::int64_t>(random());
        return floor_shift(bits, static_cast<int>(random() % 64));
    };
    for (int i = 0; i < 500'000; ++i) {
        const std::int64_t a = any_number(), b = any_number(), c = any_number();
        const int shift = static_cast<int>(random() % 127);
        for (const Rounding rounding : {Rounding::Floor, Rounding::NearestHalfUp}) {
            results.add(mul_div(a, b, c, rounding));
            results.add(mul_shift(a, b, shift, rounding));
        }
        add_native(results, static_cast<std::uint64_t>(a), static_cast<std::uint64_t>(b), random());
        const std::uint64_t n = detail::magnitude(a), d = std::max<std::uint64_t>(detail::magnitude(b), 1);
        results.add(divide(n, d).quotient);
        results.add(divide(n, d).remainder);
        const auto positive = static_cast<std::int64_t>(d >> 1 | 1);
        results.add(floored_division(a, positive).quotient);
        results.add(floored_division(a, positive).remainder);
        const auto short_d = static_cast<std::uint32_t>(d | 1);
        const std::uint64_t fitting = n % (std::uint64_t{short_d} << 32);
        results.add(native::divide_to_32(fitting, short_d).quotient);
        results.add(native::divide_to_32(fitting, short_d).remainder);
        const std::int64_t depth = std::max<std::int64_t>(detail::magnitude(c) & ((std::int64_t{1} << 59) - 1), 1);
        for (const std::int64_t inverse_z : {depth, std::int64_t{1} << shift % 60})
            add_block(results, inverse_z, a, random());
        const auto coarse = CoarseMultiplier::from_raw(std::int64_t{128} << random() % 24 | (random() & 0xff80));
        const ProjectionAxis axis{
            convert<Multiplier>(coarse), coarse, View::from_raw((std::int64_t{1} << 61) / (coarse.raw + 1)), {}};
        const auto tie = static_cast<std::int64_t>(random() & 0xffff) + 1;  // half a step at `half`
        const View half = View::from_raw(tie * coarse.raw / 128), any = View::from_raw((c >> 33 & 0x7fffffff) + 1);
        for (const std::int64_t view : {tie, -tie, -tie - 1, a >> 16}) {
            results.add(project_axis(axis, View::from_raw(view), half).raw);
            results.add(project_axis(axis, View::from_raw(view), any).raw);
        }
    }
    std::printf("%016" PRIx64 "\n", results.hash());
}
