#include "tools/gallery/numbers.h"

#include <cstdio>

namespace oblong {

Vec3<World> world_point(double x, double y, double z) {
    const auto part = [](double value) {
        return World::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(value, World::kFractionBits))));
    };
    return {part(x), part(y), part(z)};
}

Vec3<Unit> unit_vector(double x, double y, double z) {
    const double length = std::hypot(x, y, z);
    const auto part = [length](double value) {
        return Unit::from_raw(static_cast<std::int32_t>(std::lround(std::ldexp(value / length, Unit::kFractionBits))));
    };
    return {part(x), part(y), part(z)};
}

Entry entry_of(double value) {
    return Entry::from_raw(std::llround(std::ldexp(value, Entry::kFractionBits)));
}

std::string decimal_text(double value, const char* format) {
    char text[48];
    std::snprintf(text, sizeof text, format, value);
    return text;
}

}  // namespace oblong
