#include <algorithm>
#include <cstddef>
#include <span>

#include "engine/base/table.h"
#include "engine/effects/warp.h"
#include "engine/fixed/trig.h"

namespace oblong {

namespace {

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
    out.resize(pixel_count(picture.width_px, picture.height_px));
    for (std::int32_t y = 0; y < picture.height_px; ++y)
        std::copy_n(picture.row(y), picture.width_px, out.data() + std::ptrdiff_t{y} * picture.width_px);
}

/// Four pixels a round: the loop itself would take as long as what it does.
void gather(const std::uint8_t* from, std::span<const std::uint32_t> columns, std::uint8_t* to) {
    const std::uint32_t* column = columns.data();
    const std::uint32_t* const end = column + columns.size();
    for (; end - column >= 4; column += 4, to += 4) {
        to[0] = from[column[0]];
        to[1] = from[column[1]];
        to[2] = from[column[2]];
        to[3] = from[column[3]];
    }
    while (column != end) *to++ = from[*column++];
}

}  // namespace

void draw_underwater(std::int64_t time_ms, UnderwaterScratch& scratch, Framebuffer out) {
    const Axis across{out.width_px, 320}, down{out.height_px, 200};
    const Angle phase = Angle::from_bam(time_ms % kUnderwaterPeriod_ms * 65536 / kUnderwaterPeriod_ms);
    copy_picture(out, scratch.picture);
    scratch.columns.resize(as_size(out.width_px));
    for (std::int32_t x = 0; x < out.width_px; ++x)
        item(scratch.columns, x) =
            static_cast<std::uint32_t>(shift_at(phase + across.angle_at(x), down) * out.width_px + across.shrunk(x));
    for (std::int32_t y = 0; y < out.height_px; ++y) {
        const std::uint8_t* const from = scratch.picture.data() + std::ptrdiff_t{down.shrunk(y)} * out.width_px +
                                         shift_at(phase + down.angle_at(y), across);
        gather(from, scratch.columns, out.row(y));
    }
}

}  // namespace oblong
