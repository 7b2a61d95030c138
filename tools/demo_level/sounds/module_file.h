#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

/// Tracker modules as ProTracker wrote them, with eight channels.
namespace oblong::sound_source {

inline constexpr std::size_t kModuleChannels = 8, kModuleRows = 64;

/// A sample of a module: played at period 428 (its C-2), it has 8,287 samples a second.
struct ModuleSample {
    std::string name;                              ///< at most 22 letters
    std::vector<std::int8_t> wave;                 ///< an even number of samples, at most 131,070
    std::int32_t volume = 64;                      ///< 0 to 64
    std::int32_t loop_start = 0, loop_length = 0;  ///< in samples, even; length 0: no loop
};

/// A cell of a pattern; zeros: nothing happens.
struct ModuleCell {
    std::int32_t period = 0;  ///< 113 (B-3) to 856 (C-1)
    std::int32_t sample = 0;  ///< 1 to 31
    std::int32_t effect = 0, parameter = 0;
};

using ModulePattern = std::array<std::array<ModuleCell, kModuleChannels>, kModuleRows>;

struct Module {
    std::string title;                  ///< at most 20 letters
    std::vector<ModuleSample> samples;  ///< at most 31
    std::vector<ModulePattern> patterns;
    std::vector<std::uint8_t> orders;  ///< patterns, one after the other; at most 128
};

std::vector<std::uint8_t> encode_module(const Module& module);

/// The period of a note, 0 for C-1 to 35 for B-3.
std::int32_t period_of(std::int32_t note);

}  // namespace oblong::sound_source
