#pragma once

#include "engine/math/basis.h"

namespace oblong {

/// view_basis() in a world with y up (x right, z forward, left-handed: the axes of an unturned view): yaw turns forward
/// toward +x, then pitch turns forward toward up, then roll turns right toward up. At 0, 0, 0 the axes are the world's.
Basis y_up_basis(Angle yaw, Angle pitch, Angle roll);

/// The axes before y_up_basis() rounds them: each component within 2^-57.
struct FineBasis {
    Vec3<Sine60> right, up, forward;
};
FineBasis y_up_fine_basis(Angle yaw, Angle pitch, Angle roll);

/// How far axes are from orthonormal: the largest |r_i . r_j - d_ij|. Unless it is 0, products of components do not
/// give lengths and angles (Muratori). Each axis is shorter than 1.6.
Sine60 orthonormal_flaw(const Basis& basis);

/// The largest flaw from rounding components to 2^-30, with a margin: 2^-26.
inline constexpr Sine60 kOrthonormalFlaw = Sine60::from_raw(std::int64_t{1} << (60 - 26));
bool is_orthonormal(const Basis& basis);

/// Orthonormal axes of the same handedness (Gram and Schmidt): forward keeps its direction, up loses its component
/// along forward, right follows from both. Zero or parallel axes are replaced by perpendicular ones.
Basis orthonormalised(const Basis& basis);

}  // namespace oblong
