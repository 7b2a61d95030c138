#pragma once

#include <cstdint>
#include <vector>

/// Sounds out of integers: tones, noise, and filters, the same on every machine.
namespace oblong::synth {

inline constexpr std::int32_t kRate_hz = 22'050;

/// Samples at kRate_hz, kOne being full scale; sums may be larger.
using Samples = std::vector<std::int32_t>;
inline constexpr std::int32_t kOne = 1 << 20;

std::size_t samples_in(std::int32_t ms);

/// Numbers that look like chance; equal seeds give equal ones. The seed is not 0.
class Chance {
  public:
    explicit Chance(std::uint32_t seed) : state_(seed) {}
    std::uint32_t next();
    /// From `least` to `most`.
    std::int32_t between(std::int32_t least, std::int32_t most);

  private:
    std::uint32_t state_;
};

Samples silence(std::int32_t ms);
Samples noise(std::int32_t ms, std::uint32_t seed);
/// A sine that glides from one frequency to another, in hundredths of a hertz.
Samples tone(std::int32_t ms, std::int64_t from_chz, std::int64_t to_chz);
/// A sine of whole cycles in a loop of so many samples.
Samples cycles_in(std::size_t samples, std::int32_t cycles);
/// A sine of whole cycles in a loop of `ms`, from 0 to 1 after its `power`-th power: 1 - a swell, more - short swells.
Samples swell(std::int32_t ms, std::int32_t cycles, std::int32_t start_percent, int power = 1);

/// Multiplied by a number of percent, or sample by sample.
Samples scaled(Samples samples, std::int32_t percent);
Samples times(Samples samples, const Samples& factors);
/// A linear rise, then halved again and again.
Samples shaped(Samples samples, std::int32_t rise_ms, std::int32_t half_life_ms);
/// Filters of 6 dB an octave.
Samples low_passed(Samples samples, std::int32_t hz);
Samples high_passed(Samples samples, std::int32_t hz);
/// What rings at a frequency when it is struck by samples, and halves again and again; a strike of kOne gives about
/// kOne.
Samples ringing(const Samples& strike, std::int32_t hz, std::int32_t half_life_ms);

/// Adds samples from a place on; what is past the end is left out, or goes on at the start.
void add(Samples& to, const Samples& what, std::int32_t at_ms, std::int32_t percent = 100);
void add_around(Samples& to, const Samples& what, std::int32_t at_ms, std::int32_t percent = 100);

/// A loop: the last `overlap_ms` are blended into the start, at the same power throughout.
Samples looped(const Samples& samples, std::int32_t overlap_ms);

/// 16-bit samples with a peak of `peak_percent` of full scale and without a constant part. What is no loop begins and
/// ends at 0.
std::vector<std::int16_t> finished(Samples samples, bool is_loop, std::int32_t peak_percent);

}  // namespace oblong::synth
