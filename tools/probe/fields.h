#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/fixed/fixed.h"
#include "engine/fixed/trig.h"
#include "engine/math/soft_float.h"
#include "engine/math/vec.h"
#include "engine/view/projection.h"
#include "engine/view/screen.h"

namespace oblong {

/// Thrown if a query cannot be answered: the answer is then the line `unsupported`.
struct Unsupported {};

/// A screen mode and the field of view across it.
struct ModeAndView {
    ScreenMode mode;
    Degrees field_of_view;
    SoftFloat fine_field_of_view;  ///< degrees, with all its decimals
};

/// The fields of one query, read from left to right. Each reader throws Unsupported for a missing or invalid field.
class Fields {
  public:
    /// Fields are separated by single spaces.
    explicit Fields(std::string_view line);

    std::size_t left() const { return texts_.size() - next_; }
    /// Call it when all fields have been read: throws if some are left.
    void expect_end() const;

    std::string_view text();
    std::int64_t integer(std::int64_t least, std::int64_t most);
    /// An integer of any sign and any number of digits, in 1/65536 of a turn.
    Angle angle();
    /// A length, an exact multiple of 1/256 of at most 32,767: 24.8.
    Fixed<std::int32_t, 8> length();
    Vec3<Fixed<std::int32_t, 8>> point();
    /// A texture coordinate, texels: any decimal number of at most 32,767.
    Texel texel();
    /// Five fields: W H PN PD FOV.
    ModeAndView mode();

  private:
    std::vector<std::string> texts_;
    std::size_t next_ = 0;
};

/// The projection of a frame. Throws Unsupported for fields of view below a thousandth of a degree, for which the
/// multipliers would be wrong.
Projection frame_lens(const ModeAndView& view);

/// The multipliers of make_projection() with 62 significant bits.
struct FarProjection {
    SoftFloat x, y;
    ScreenWide centre_x, centre_y;
};

/// Any field of view above 0 and below 180 degrees, with all its bits: for a d of a million pixels, those of Degrees
/// are too few. `mode` as for make_projection().
FarProjection make_far_projection(const ScreenMode& mode, const SoftFloat& field_of_view_degrees);

/// raw / 2^fraction_bits with all its decimals, of which a binary fraction has finitely many. `fraction_bits` 0 to 60.
std::string format_fixed(std::int64_t raw, int fraction_bits);

template <class Int, int Frac>
std::string format_fixed(Fixed<Int, Frac> value) {
    return format_fixed(value.raw, Frac);
}

}  // namespace oblong
