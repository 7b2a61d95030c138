#include "tools/demo_level/sounds/synth.h"

#include <algorithm>
#include <cstdlib>
#include <numeric>

#include "engine/fixed/root.h"
#include "engine/fixed/trig.h"

namespace oblong::synth {
namespace {

constexpr std::int64_t kOne_30 = std::int64_t{1} << 30;
constexpr std::int64_t kLogOf2_30 = 744'261'118;
constexpr std::int64_t kTurn_30 = 6'746'518'852;  // 2 pi

std::int32_t sample_of(Unit unit) {
    return static_cast<std::int32_t>(unit.raw / (kOne_30 / kOne));
}

std::int64_t product_30(std::int64_t value, std::int64_t factor_30) {
    return value * factor_30 / kOne_30;
}

// The factor of each sample that halves in `half_life_ms`: 2^(-1 / n).
std::int64_t decay_30(std::int32_t half_life_ms) {
    const std::int64_t n = std::max<std::int64_t>(8, static_cast<std::int64_t>(samples_in(half_life_ms)));
    return kOne_30 - kLogOf2_30 / n + kLogOf2_30 * kLogOf2_30 / (2 * n * n * kOne_30);
}

Angle angle_per_sample(std::int64_t hz) {
    return Angle::from_bam(hz * 65'536 / kRate_hz);
}

}  // namespace

std::size_t samples_in(std::int32_t ms) {
    return static_cast<std::size_t>(std::int64_t{ms} * kRate_hz / 1000);
}

std::uint32_t Chance::next() {
    state_ ^= state_ << 13;
    state_ ^= state_ >> 17;
    state_ ^= state_ << 5;
    return state_;
}

std::int32_t Chance::between(std::int32_t least, std::int32_t most) {
    return least + static_cast<std::int32_t>(next() % static_cast<std::uint32_t>(most - least + 1));
}

Samples silence(std::int32_t ms) {
    return Samples(samples_in(ms));
}

Samples noise(std::int32_t ms, std::uint32_t seed) {
    Chance chance(seed * 2'654'435'761u | 1u);
    for (int i = 0; i < 16; ++i) chance.next();
    Samples samples = silence(ms);
    for (std::int32_t& sample : samples) sample = static_cast<std::int32_t>(chance.next() >> 11) - kOne;
    return samples;
}

Samples tone(std::int32_t ms, std::int64_t from_chz, std::int64_t to_chz) {
    Samples samples = silence(ms);
    const auto count = static_cast<std::int64_t>(samples.size());
    std::int64_t phase = 0;  // 2^16 * 100 * kRate_hz to the turn
    for (std::int64_t i = 0; i < count; ++i) {
        samples[static_cast<std::size_t>(i)] = sample_of(sine(Angle::from_bam(phase / (100 * kRate_hz))));
        phase += (from_chz + (to_chz - from_chz) * i / count) * 65'536;
    }
    return samples;
}

Samples cycles_in(std::size_t samples, std::int32_t cycles) {
    Samples wave(samples);
    const auto count = static_cast<std::int64_t>(samples);
    for (std::int64_t i = 0; i < count; ++i)
        wave[static_cast<std::size_t>(i)] = sample_of(sine(Angle::from_bam(i * cycles * 65'536 / count)));
    return wave;
}

Samples swell(std::int32_t ms, std::int32_t cycles, std::int32_t start_percent, int power) {
    Samples samples = silence(ms);
    const auto count = static_cast<std::int64_t>(samples.size());
    for (std::int64_t i = 0; i < count; ++i) {
        const Angle angle = Angle::from_bam(i * cycles * 65'536 / count + start_percent * 65'536 / 100);
        const std::int64_t level = (kOne - sample_of(cosine(angle))) / 2;
        std::int64_t product = level;
        for (int n = 1; n < power; ++n) product = product * level / kOne;
        samples[static_cast<std::size_t>(i)] = static_cast<std::int32_t>(product);
    }
    return samples;
}

Samples scaled(Samples samples, std::int32_t percent) {
    for (std::int32_t& sample : samples) sample = static_cast<std::int32_t>(std::int64_t{sample} * percent / 100);
    return samples;
}

Samples times(Samples samples, const Samples& factors) {
    for (std::size_t i = 0; i < samples.size() && i < factors.size(); ++i)
        samples[i] = static_cast<std::int32_t>(std::int64_t{samples[i]} * factors[i] / kOne);
    return samples;
}

Samples shaped(Samples samples, std::int32_t rise_ms, std::int32_t half_life_ms) {
    const std::int64_t decay = decay_30(half_life_ms);
    const auto rise = static_cast<std::int64_t>(samples_in(rise_ms));
    std::int64_t level_30 = kOne_30;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        const auto at = static_cast<std::int64_t>(i);
        if (at >= rise) level_30 = product_30(level_30, decay);
        const std::int64_t level = at < rise ? kOne_30 * at / rise : level_30;
        samples[i] = static_cast<std::int32_t>(product_30(samples[i], level));
    }
    return samples;
}

Samples low_passed(Samples samples, std::int32_t hz) {
    const std::int64_t x_30 = hz * kTurn_30 / kRate_hz, share_30 = x_30 * kOne_30 / (kOne_30 + x_30);
    std::int64_t state_8 = 0;
    for (std::int32_t& sample : samples) {
        state_8 += product_30(std::int64_t{sample} * 256 - state_8, share_30);
        sample = static_cast<std::int32_t>(state_8 / 256);
    }
    return samples;
}

Samples high_passed(Samples samples, std::int32_t hz) {
    const Samples low = low_passed(samples, hz);
    for (std::size_t i = 0; i < samples.size(); ++i) samples[i] -= low[i];
    return samples;
}

// y = sin(w) x + 2 r cos(w) y1 - r^2 y2.
Samples ringing(const Samples& strike, std::int32_t hz, std::int32_t half_life_ms) {
    const Angle w = angle_per_sample(hz);
    const std::int64_t r = decay_30(half_life_ms);
    const std::int64_t first = product_30(2 * r, cosine(w).raw), second = product_30(r, r), gain = sine(w).raw;
    std::int64_t last = 0, last_but_one = 0;
    Samples samples(strike.size());
    for (std::size_t i = 0; i < strike.size(); ++i) {
        const std::int64_t now =
            product_30(std::int64_t{strike[i]} * 16, gain) + product_30(last, first) - product_30(last_but_one, second);
        last_but_one = last;
        last = now;
        samples[i] = static_cast<std::int32_t>(now / 16);
    }
    return samples;
}

void add(Samples& to, const Samples& what, std::int32_t at_ms, std::int32_t percent) {
    const std::size_t at = samples_in(at_ms);
    for (std::size_t i = 0; i < what.size() && at + i < to.size(); ++i)
        to[at + i] += static_cast<std::int32_t>(std::int64_t{what[i]} * percent / 100);
}

void add_around(Samples& to, const Samples& what, std::int32_t at_ms, std::int32_t percent) {
    const std::size_t at = samples_in(at_ms);
    for (std::size_t i = 0; i < what.size(); ++i)
        to[(at + i) % to.size()] += static_cast<std::int32_t>(std::int64_t{what[i]} * percent / 100);
}

Samples looped(const Samples& samples, std::int32_t overlap_ms) {
    const std::size_t overlap = samples_in(overlap_ms), count = samples.size() - overlap;
    Samples loop(samples.begin(), samples.begin() + static_cast<std::ptrdiff_t>(count));
    const auto root_10 = [&](std::size_t part) {
        return static_cast<std::int64_t>(integer_root(std::uint64_t{part} * (1u << 20) / overlap));
    };
    for (std::size_t i = 0; i < overlap; ++i)
        loop[i] =
            static_cast<std::int32_t>((samples[i] * root_10(i) + samples[count + i] * root_10(overlap - i)) / 1024);
    return loop;
}

namespace {

// Away with what is below hearing, and with a step at either end.
Samples with_soft_ends(Samples samples) {
    samples = high_passed(std::move(samples), 16);
    const std::size_t count = samples.size(), rise = 12, fall = std::min(count, samples_in(25));
    for (std::size_t i = 0; i < rise && i < count; ++i)
        samples[i] = samples[i] * static_cast<std::int32_t>(i) / static_cast<std::int32_t>(rise);
    for (std::size_t i = 0; i < fall; ++i)
        samples[count - 1 - i] = static_cast<std::int32_t>(
            std::int64_t{samples[count - 1 - i]} * static_cast<std::int64_t>(i) / static_cast<std::int64_t>(fall));
    return samples;
}

}  // namespace

std::vector<std::int16_t> finished(Samples samples, bool is_loop, std::int32_t peak_percent) {
    if (!is_loop) samples = with_soft_ends(std::move(samples));
    const std::int64_t sum = std::accumulate(samples.begin(), samples.end(), std::int64_t{0});
    const auto mean = is_loop ? static_cast<std::int32_t>(sum / static_cast<std::int64_t>(samples.size())) : 0;
    std::int64_t peak = 1;
    for (std::int32_t& sample : samples) {
        sample -= mean;
        peak = std::max(peak, std::int64_t{std::abs(sample)});
    }
    std::vector<std::int16_t> wave;
    for (const std::int32_t sample : samples)
        wave.push_back(static_cast<std::int16_t>(sample * std::int64_t{32'767} * peak_percent / 100 / peak));
    return wave;
}

}  // namespace oblong::synth
