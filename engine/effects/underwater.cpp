#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

#include "engine/base/table.h"
#include "engine/effects/warp.h"
#include "engine/fixed/trig.h"

namespace oblong {

namespace {

constexpr std::int32_t kCopied_px = 16;

/// One axis of a picture, of which `usual_px` are what 320x200 has.
struct Axis {
    std::int32_t size_px, usual_px;

    std::int32_t amplitude_px() const { return std::max((size_px * 3 + usual_px / 2) / usual_px, 1); }
    /// 128 pixels of 320x200 are a wave.
    Angle angle_at(std::int32_t place_px) const {
        return Angle::from_bam(std::int64_t{place_px} * usual_px * 512 / size_px);
    }
    /// The place that is shown at `place_px`, but for the waves.
    std::int32_t shrunk(std::int32_t place_px) const { return place_px * (size_px - 2 * amplitude_px()) / size_px; }
};

/// How far a wave of this angle moves along an axis, pixels: 0 to twice the amplitude.
std::int32_t shift_at(Angle angle, const Axis& axis) {
    using Pixels = Fixed<std::int64_t, 30>;
    const std::int32_t amplitude_px = axis.amplitude_px();
    const Pixels moved = convert<Pixels>(sine(angle)) * amplitude_px;
    return amplitude_px + static_cast<std::int32_t>(floor_of(moved + Pixels::from_raw(1 << 29)));
}

void copy_picture(Framebuffer picture, std::vector<std::uint8_t>& out) {
    out.resize(pixel_count(picture.width_px, picture.height_px) + kCopied_px);  // the last run may read further
    for (std::int32_t y = 0; y < picture.height_px; ++y)
        std::copy_n(picture.row(y), picture.width_px, out.data() + std::ptrdiff_t{y} * picture.width_px);
}

/// Where neighbouring pixels of a row come from neighbours: the waves along columns move in steps of a whole pixel.
void find_runs(Angle phase, const Axis& across, const Axis& down, std::vector<WaveRun>& runs) {
    runs.clear();
    std::uint32_t next = 0;
    for (std::int32_t x = 0; x < across.size_px; ++x, ++next) {
        const auto from =
            static_cast<std::uint32_t>(shift_at(phase + across.angle_at(x), down) * across.size_px + across.shrunk(x));
        if (runs.empty() || from != next || runs.back().count == kCopied_px) runs.push_back({next = from, x, 0});
        ++runs.back().count;
    }
}

/// Copies sixteen pixels a run: what that writes too much, the next run overwrites. Only those near to the end of the
/// row, after which others' pixels may lie, are copied as long as they are.
void copy_runs(const std::uint8_t* from, std::span<const WaveRun> runs, std::int32_t width_px, std::uint8_t* row) {
    std::size_t i = 0;
    for (; i < runs.size() && runs[i].first <= width_px - kCopied_px; ++i)
        std::memcpy(row + runs[i].first, from + runs[i].from, kCopied_px);
    for (; i < runs.size(); ++i) std::copy_n(from + runs[i].from, runs[i].count, row + runs[i].first);
}

}  // namespace

void draw_underwater(std::int64_t time_ms, UnderwaterScratch& scratch, Framebuffer out) {
    const Axis across{out.width_px, 320}, down{out.height_px, 200};
    const Angle phase = Angle::from_bam(time_ms % kUnderwaterPeriod_ms * 65536 / kUnderwaterPeriod_ms);
    copy_picture(out, scratch.picture);
    find_runs(phase, across, down, scratch.runs);
    for (std::int32_t y = 0; y < out.height_px; ++y) {
        const std::uint8_t* const from = scratch.picture.data() + std::ptrdiff_t{down.shrunk(y)} * out.width_px +
                                         shift_at(phase + down.angle_at(y), across);
        copy_runs(from, scratch.runs, out.width_px, out.row(y));
    }
}

}  // namespace oblong
