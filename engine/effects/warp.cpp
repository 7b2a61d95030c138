#include "engine/effects/warp.h"

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <span>

#include "engine/base/table.h"
#include "engine/fixed/trig.h"

namespace oblong {
namespace {

constexpr std::uint32_t kAmplitude_texels = 8;

/// amplitude (1 + sin), which is never below 0.
std::uint32_t raised_sine_16(Angle angle) {
    return static_cast<std::uint32_t>((std::int64_t{1} << 30) + floor_of<30>(sine(angle))) /
           ((1u << 14) / kAmplitude_texels);
}

constexpr std::int32_t kCopied_px = 16;

/// The shift of a wave at this angle, pixels: 0 to twice the amplitude.
std::int32_t shift_at(Angle angle, std::int32_t amplitude_px) {
    using Pixels = Fixed<std::int64_t, 30>;
    const Pixels moved = convert<Pixels>(sine(angle)) * amplitude_px;
    return amplitude_px + static_cast<std::int32_t>(floor_of(moved + Pixels::from_raw(1 << 29)));
}

/// An axis of this many pixels; 320x200 has `usual_px`, where a wave is 128 pixels long and its amplitude 3.
WaveAxis make_axis(std::int32_t size_px, std::int32_t usual_px) {
    WaveAxis axis;
    axis.amplitude_px = std::max((size_px * 3 + usual_px / 2) / usual_px, 1);
    const std::int32_t wave_usual_px = size_px * 128;
    axis.period_px = wave_usual_px % usual_px == 0 ? wave_usual_px / usual_px : size_px;
    for (std::int32_t place = 0; place < size_px; ++place)
        axis.places.push_back({Angle::from_bam(std::int64_t{place} * usual_px * 512 / size_px),
                               place * (size_px - 2 * axis.amplitude_px) / size_px});
    return axis;
}

/// The shifts, along the other axis and with this amplitude, of the waves along an axis. They repeat.
void find_shifts(Angle phase, const WaveAxis& axis, std::int32_t amplitude_px, std::vector<std::int32_t>& shifts) {
    shifts.clear();
    for (const WavePlace& place : axis.places) {
        const std::size_t period = as_size(axis.period_px), at = shifts.size();
        shifts.push_back(at < period ? shift_at(phase + place.angle, amplitude_px) : shifts[at - period]);
    }
}

void copy_picture(Framebuffer picture, std::vector<std::uint8_t>& out) {
    out.resize(pixel_count(picture.width_px, picture.height_px) + kCopied_px);  // the last run reads beyond it
    for (std::int32_t y = 0; y < picture.height_px; ++y)
        std::copy_n(picture.row(y), picture.width_px, out.data() + std::ptrdiff_t{y} * picture.width_px);
}

/// Finds the runs of a row's pixels that are copied from consecutive pixels: the waves along columns move in whole
/// pixels.
void find_runs(const WaveAxis& across, std::span<const std::int32_t> shifts, std::vector<WaveRun>& runs) {
    const auto size_px = static_cast<std::int32_t>(shifts.size());
    runs.clear();
    std::uint32_t next = 0;
    for (std::int32_t x = 0; x < size_px; ++x, ++next) {
        const auto from = static_cast<std::uint32_t>(item(shifts, x) * size_px + item(across.places, x).from);
        if (runs.empty() || from != next || runs.back().count == kCopied_px) runs.push_back({next = from, x, 0});
        ++runs.back().count;
    }
}

/// Copies sixteen pixels a run; the next run overwrites the excess. Runs near the end of the row, beyond which may be
/// pixels of others, are copied in their exact length.
void copy_runs(const std::uint8_t* from, std::span<const WaveRun> runs, std::int32_t width_px, std::uint8_t* row) {
    std::size_t i = 0;
    for (; i < runs.size() && runs[i].first <= width_px - kCopied_px; ++i)
        std::memcpy(row + runs[i].first, from + runs[i].from, kCopied_px);
    for (; i < runs.size(); ++i) std::copy_n(from + runs[i].from, runs[i].count, row + runs[i].first);
}

}  // namespace

WarpTables make_warp_tables(std::int64_t time_ms) {
    constexpr std::uint32_t kEntries = WarpTable::kEntries;
    const std::int64_t phase = time_ms % kWarpPeriod_ms * 65536 / kWarpPeriod_ms;
    WarpTables tables;
    for (std::uint32_t i = 0; i < kEntries; ++i)
        tables[0].shift_16[i] = raised_sine_16(Angle::from_bam(phase + i * (65536 / kEntries)));
    for (int mip = 1; mip < 4; ++mip)
        for (std::uint32_t i = 0; i < kEntries; ++i)
            item(tables, mip).shift_16[i] = tables[0].shift_16[(i << mip) % kEntries] >> mip;
    return tables;
}

void draw_underwater(std::int64_t time_ms, UnderwaterScratch& scratch, Framebuffer out) {
    if (scratch.across.places.size() != as_size(out.width_px)) scratch.across = make_axis(out.width_px, 320);
    if (scratch.down.places.size() != as_size(out.height_px)) scratch.down = make_axis(out.height_px, 200);
    const WaveAxis &across = scratch.across, &down = scratch.down;
    const Angle phase = Angle::from_bam(time_ms % kUnderwaterPeriod_ms * 65536 / kUnderwaterPeriod_ms);
    copy_picture(out, scratch.picture);
    find_shifts(phase, across, down.amplitude_px, scratch.shifts);
    find_runs(across, scratch.shifts, scratch.runs);
    find_shifts(phase, down, across.amplitude_px, scratch.shifts);
    for (std::int32_t y = 0; y < out.height_px; ++y) {
        const std::uint8_t* const from =
            scratch.picture.data() + std::ptrdiff_t{item(down.places, y).from} * out.width_px + item(scratch.shifts, y);
        copy_runs(from, scratch.runs, out.width_px, out.row(y));
    }
}

}  // namespace oblong
