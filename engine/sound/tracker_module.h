#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace oblong {

/// A sample of a module: 8-bit values, played once, or to some value and then the loop repeatedly.
struct ModuleSample {
    std::vector<std::int8_t> samples;
    std::int32_t finetune_8 = 0;                  ///< eighths of a semitone, -8 to 7
    std::int32_t volume_64 = 0;                   ///< 0 to 64
    std::size_t loop_start = 0, loop_length = 0;  ///< within the samples; length 0: no loop
    std::size_t played = 0;                       ///< of the samples, before the loop
};

/// One channel's note in one row.
struct ModuleNote {
    std::uint8_t sample = 0;   ///< 1 to 31; 0: unchanged
    std::uint16_t period = 0;  ///< in clocks of the Amiga for a sample; 0: no new note
    std::uint8_t effect = 0, parameter = 0;
};

inline constexpr std::size_t kPatternRows = 64, kMostModuleChannels = 32;
inline constexpr std::int32_t kMostModuleVolume_64 = 64;
inline constexpr std::int32_t kLeastPeriod = 113, kMostPeriod = 856;  ///< of ProTracker's notes

/// A ProTracker module with 31 samples, or a module of other trackers with more channels.
struct TrackerModule {
    std::size_t channels = 4;           ///< 1 to 32
    std::vector<ModuleSample> samples;  ///< 31
    std::vector<std::uint8_t> orders;   ///< patterns in the order of playing: 1 to 128, all in `notes`
    std::size_t restart = 0;            ///< the order after the last
    std::vector<ModuleNote> notes;      ///< by pattern, row and channel
    bool is_protrackers = false;        ///< all notes are ones that ProTracker has

    /// Slides of a period end there: at ProTracker's notes, or some octaves beyond.
    std::int32_t least_period() const { return is_protrackers ? kLeastPeriod : 14; }
    std::int32_t most_period() const { return is_protrackers ? kMostPeriod : 3'424; }

    std::span<const ModuleNote> row(std::size_t pattern, std::size_t row) const {
        return std::span<const ModuleNote>(notes).subspan((pattern * kPatternRows + row) * channels, channels);
    }
};

/// Reads a module of 31 samples: of 4 channels ("M.K." at offset 1080), or of any number ("8CHN", "16CH"), by its marks
/// of other trackers, too. Samples beyond the end of the file are cut off there, packed ones unpacked; a number of no
/// sample in a note is taken for none. Throws InputError with the offset of the error.
TrackerModule parse_module(std::span<const std::uint8_t> file);

}  // namespace oblong
