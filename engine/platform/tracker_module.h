#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace oblong {

/// A sound of a module: 8-bit samples, once, or the loop again and again after the first time.
struct ModuleSample {
    std::vector<std::int8_t> samples;
    std::int32_t finetune_8 = 0;                  ///< eighths of a semitone, -8 to 7
    std::int32_t volume_64 = 0;                   ///< 0 to 64
    std::size_t loop_start = 0, loop_length = 0;  ///< within the samples; 0: it ends
};

/// What one channel is told in one row.
struct ModuleNote {
    std::uint8_t sample = 0;   ///< 1 to 31; 0: as it was
    std::uint16_t period = 0;  ///< of the Amiga's clock, a sample; 0: no new note
    std::uint8_t effect = 0, parameter = 0;
};

inline constexpr std::size_t kPatternRows = 64, kMostModuleChannels = 32;
inline constexpr std::int32_t kMostModuleVolume_64 = 64;

/// A ProTracker module of 31 samples, or one of other trackers with more channels.
struct TrackerModule {
    std::size_t channels = 4;           ///< 1 to 32
    std::vector<ModuleSample> samples;  ///< 31
    std::vector<std::uint8_t> orders;   ///< patterns as they are played: 1 to 128, each with its notes in the list
    std::size_t restart = 0;            ///< the order after the last
    std::vector<ModuleNote> notes;      ///< of pattern 0, row 0, channel 0 first, then channel 1

    std::span<const ModuleNote> row(std::size_t pattern, std::size_t row) const {
        return std::span<const ModuleNote>(notes).subspan((pattern * kPatternRows + row) * channels, channels);
    }
};

/// Reads a module of 4 channels ("M.K.", "M!K!" or "FLT4" at offset 1080) or of any number ("8CHN", "16CH"). Samples
/// that the file ends within are as long as it has them. Throws InputError with the offset of what is wrong.
TrackerModule parse_module(std::span<const std::uint8_t> file);

}  // namespace oblong
