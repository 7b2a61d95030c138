#pragma once

#include "engine/io/doubles.h"
#include "engine/math/matrix.h"

/// Short ways to write the numbers of the seeds, and to read those of the engine.
namespace oblong::test {

using Whole = Fixed<std::int32_t, 0>;

constexpr Vec3<Whole> whole(std::int32_t x, std::int32_t y, std::int32_t z) {
    return {Whole::from_int(x), Whole::from_int(y), Whole::from_int(z)};
}

constexpr Entry entry(std::int64_t numerator, std::int64_t denominator = 1) {
    return divide<Entry>(Entry::from_int(numerator), Entry::from_int(denominator));
}

constexpr Vec4 point(Entry x, Entry y, Entry z) {
    return {x, y, z, entry(1)};
}

/// A whole point in viewspace.
constexpr Vec3<View> view_point(std::int64_t x, std::int64_t y, std::int64_t z) {
    return {View::from_int(x), View::from_int(y), View::from_int(z)};
}

/// Seed 2's and seed 4's projection: (x, y, z, 1) to (x, y, z, z / d).
inline Matrix4 perspective(Entry distance) {
    Matrix4 matrix = Matrix4::identity();
    matrix.rows[3] = {Entry{}, Entry{}, reciprocal<Entry>(distance), Entry{}};
    return matrix;
}

}  // namespace oblong::test
