#include "engine/library/ogg.h"

#include <algorithm>
#include <array>
#include <limits>
#include <memory>
#include <string>

#include "engine/base/input_error.h"

// Its numbers are floating point, and differ between machines by rounding: sounds alone are decoded so, no picture.
#define STB_VORBIS_NO_STDIO
#define STB_VORBIS_NO_PUSHDATA_API
#include <stb/stb_vorbis.h>

namespace oblong {
namespace {

struct CloseVorbis {
    void operator()(stb_vorbis* file) const { stb_vorbis_close(file); }
};

constexpr int kMostOggChannels = 16;  // stb's limit

}  // namespace

bool is_ogg(std::span<const std::uint8_t> file) {
    constexpr std::array<std::uint8_t, 4> kMark{'O', 'g', 'g', 'S'};
    return file.size() > kMark.size() && std::equal(kMark.begin(), kMark.end(), file.begin());
}

SoundSamples decode_ogg(std::span<const std::uint8_t> file) {
    int error = 0;
    const std::size_t most = std::numeric_limits<int>::max();
    const std::unique_ptr<stb_vorbis, CloseVorbis> vorbis(
        stb_vorbis_open_memory(file.data(), static_cast<int>(std::min(file.size(), most)), &error, nullptr));
    if (!vorbis)
        throw InputError(
            "file", "no sound that stb_vorbis decodes (its error " + std::to_string(error) + "), expected Ogg Vorbis");
    const stb_vorbis_info info = stb_vorbis_get_info(vorbis.get());
    SoundSamples sound{static_cast<std::int32_t>(info.sample_rate), {}};
    std::array<std::int16_t, 1024 * kMostOggChannels> frames;
    while (const int count = stb_vorbis_get_samples_short_interleaved(vorbis.get(), info.channels, frames.data(),
                                                                      1024 * info.channels))
        for (int i = 0; i < count; ++i) {
            int sum = 0;
            for (int channel = 0; channel < info.channels; ++channel)
                sum += frames[static_cast<std::size_t>(i * info.channels + channel)];
            sound.samples.push_back(static_cast<std::int16_t>(sum / info.channels));
        }
    if (sound.samples.empty() || sound.rate_hz < 1) throw InputError("file", "no samples, expected one or more");
    return sound;
}

}  // namespace oblong
