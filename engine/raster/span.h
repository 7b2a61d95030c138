#pragma once

#include <cstdint>

namespace oblong {

/// Pixels [first, end) of row y.
struct Span {
    std::int32_t y, first, end;
};

}  // namespace oblong
