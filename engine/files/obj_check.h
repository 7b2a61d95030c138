#pragma once

#include <cstdint>
#include <string_view>

namespace oblong {

struct ObjSummary {
    std::int64_t faces = 0;
    bool has_smoothing_groups = false;
};

/// Checks what tinyobjloader does not: that the words of v, vt, vn and f lines are numbers in range, and that the
/// corners of faces exist. Throws InputError with the line.
ObjSummary check_obj(std::string_view text, double scale);

}  // namespace oblong
