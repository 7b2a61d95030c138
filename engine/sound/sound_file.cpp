#include "engine/sound/sound_file.h"

#include <map>
#include <optional>
#include <string>

#include "engine/base/little_endian.h"
#include "engine/base/table.h"
#include "engine/effects/entity_values.h"
#include "engine/io/files.h"
#include "engine/level/entity_classes.h"

namespace oblong {
namespace {

// Names of chunks and the format's number (RFC 2361), as little-endian integers.
constexpr std::uint32_t kRiff = 0x4646'4952, kWave = 0x4556'4157, kFormat = 0x2074'6d66, kData = 0x6174'6164;
constexpr std::uint16_t kPcm = 1, kExtensible = 0xfffe;
// A program that writes into a pipe does not know a length: it leaves 0, or writes one as great as can be. And the
// file's is as if there were no samples, or also 0 or great.
constexpr std::uint32_t kEndless = 0x7fff'0000;
constexpr std::uint32_t kHighestRate_hz = 192'000;

struct WavFormat {
    std::uint16_t bits = 0, channels = 1;
    std::int32_t rate_hz = 0;
};

WavFormat read_format(LittleEndianReader chunk) {
    const std::size_t at = chunk.offset();
    auto kind = chunk.next<std::uint16_t>();
    const auto channels = chunk.next<std::uint16_t>();
    const auto rate_hz = chunk.next<std::uint32_t>();
    chunk.take(6);  // bytes a second and a frame, which follow from the others
    const auto bits = chunk.next<std::uint16_t>();
    if (kind == kExtensible) {
        chunk.take(8);  // the size of what follows, the bits that are used, the place of speakers
        kind = chunk.next<std::uint16_t>();
    }
    expect_at(at, kind == kPcm, "format " + std::to_string(kind) + ", expected 1: PCM");
    expect_at(at + 2, channels == 1 || channels == 2, std::to_string(channels) + " channels, expected 1 or 2");
    expect_at(at + 4, rate_hz > 0 && rate_hz <= kHighestRate_hz, std::to_string(rate_hz) + " Hz, expected 1 to 192000");
    expect_at(at + 14, bits == 8 || bits == 16, std::to_string(bits) + " bits a sample, expected 8 or 16");
    return {bits, channels, static_cast<std::int32_t>(rate_hz)};
}

// 8-bit samples are unsigned, 16-bit samples signed. Those of several channels become their mean.
std::vector<std::int16_t> read_samples(std::span<const std::uint8_t> bytes, const WavFormat& format) {
    std::vector<std::int16_t> samples;
    samples.reserve(bytes.size() / (std::size_t{format.channels} * format.bits / 8));
    LittleEndianReader in(bytes);
    while (in.rest() >= std::size_t{format.channels} * format.bits / 8) {
        std::int32_t sum = 0;
        for (int channel = 0; channel < format.channels; ++channel)
            sum += format.bits == 8 ? (in.next<std::uint8_t>() - 128) * 256 : in.next<std::int16_t>();
        samples.push_back(static_cast<std::int16_t>(sum / format.channels));
    }
    return samples;
}

SoundSamples decode_wav(std::span<const std::uint8_t> file) {
    LittleEndianReader in(file, 4);
    const auto rest_of_file = in.next<std::uint32_t>();
    expect_at(8, in.rest() >= 4 && in.next<std::uint32_t>() == kWave, "no sound, expected WAVE");
    std::optional<WavFormat> format;
    while (true) {
        const std::size_t at = in.offset();
        const auto name = in.next<std::uint32_t>(), length = in.next<std::uint32_t>();
        const bool is_open = rest_of_file >= kEndless || rest_of_file + std::size_t{8} <= in.offset();
        const bool is_endless = name == kData && (length == 0 ? is_open : length >= kEndless && length > in.rest());
        const std::span<const std::uint8_t> bytes = in.take(is_endless ? in.rest() : length);
        if (name == kFormat) format = read_format(LittleEndianReader(file.first(in.offset()), at + 8));
        if (name == kData) {
            expect_at(at, format.has_value(), "samples, expected the chunk \"fmt \" before them");
            SoundSamples sound{format->rate_hz, read_samples(bytes, *format)};
            expect_at(at + 4, !sound.samples.empty(), "no samples, expected one or more");
            return sound;
        }
        in.take(length % 2);  // chunks begin at even places
    }
}

constexpr const char* kKey = "noise";

}  // namespace

SoundSamples decode_sound(std::span<const std::uint8_t> file) {
    const bool is_riff = file.size() >= 8 && LittleEndianReader(file).next<std::uint32_t>() == kRiff;
    return is_riff ? decode_wav(file) : decode_flac(file);
}

LevelSounds read_level_sounds(const Level& level, const std::vector<std::string>& folders) {
    LevelSounds read;
    read.by_entity.resize(level.entities.size(), LevelSounds::kNone);
    std::map<std::string, std::int32_t> known;
    for (std::size_t i = 0; i < level.entities.size(); ++i) {
        const Entity& entity = level.entities[i];
        const std::string name = entity.value(kKey);
        if (name.empty()) continue;
        const EntityClass* const its_class = find_entity_class(entity.value("classname"));
        if (!its_class || !find_entity_key(*its_class, kKey)) continue;
        const auto [at, is_new] = known.try_emplace(name, LevelSounds::kNone);
        if (is_new) {
            const EntityValues values(entity, i, read.warnings);
            const std::string file = find_below(folders, name);
            if (!stays_below(name))
                values.warn("noise is \"" + name + "\", expected a path of a file below the game's folder");
            else if (file.empty())
                values.warn("there is no file " + name + " for its noise, expected one in " + folders.front());
            else {
                read.sounds.push_back({name, file, read_parsed(file, decode_sound)});
                at->second = static_cast<std::int32_t>(read.sounds.size()) - 1;
            }
        }
        read.by_entity[i] = at->second;
    }
    return read;
}

}  // namespace oblong
