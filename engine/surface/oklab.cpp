#include "engine/surface/oklab.h"

#include <array>

#include "engine/base/table.h"
#include "engine/fixed/divide.h"
#include "engine/fixed/power.h"

namespace oblong {

namespace {

/// A row of one of Ottosson's matrices, in millionths.
struct Row {
    std::int32_t first, second, third;
    constexpr std::int64_t times(std::int32_t x, std::int32_t y, std::int32_t z) const {
        return std::int64_t{first} * x + std::int64_t{second} * y + std::int64_t{third} * z;
    }
};
constexpr std::int32_t kMillion = 1'000'000;
constexpr Row kLongCone{412'221, 536'333, 51'446}, kMiddleCone{211'903, 680'700, 107'397},
    kShortCone{88'302, 281'719, 629'979};
constexpr Row kLightness{210'454, 793'618, -4'072}, kGreenRed{1'977'998, -2'428'592, 450'594},
    kBlueYellow{25'904, 782'772, -808'676};

/// Linear light of an sRGB channel's 256 values (IEC 61966-2-1), 30 fraction bits; the last value is repeated.
constexpr auto kLinear_30 = [] {
    std::array<std::int32_t, 257> table{};
    for (std::int64_t channel = 0; channel < 256; ++channel) {
        const std::int64_t base_30 = ((channel * 1000 + 255 * 55) << 30) / (255 * 1055);
        const bool is_in_linear_part = channel * 100'000 <= 255 * 4045;
        item(table, channel) = static_cast<std::int32_t>(
            is_in_linear_part ? (channel << 30) * 100 / (255 * 1292)
                              : std::int64_t{power_30(static_cast<std::uint32_t>(base_30), 12, 5)});
    }
    table[256] = table[255];
    return table;
}();

std::int32_t linear_30(std::int32_t channel_8) {
    const std::int32_t below = item(kLinear_30, channel_8 >> 8), above = item(kLinear_30, (channel_8 >> 8) + 1);
    return below + static_cast<std::int32_t>(std::int64_t{above - below} * (channel_8 & 0xff) >> 8);
}

std::int32_t cone_response_30(const Row& cone, std::int32_t red_30, std::int32_t green_30, std::int32_t blue_30) {
    const auto light = static_cast<std::uint64_t>(cone.times(red_30, green_30, blue_30));
    return static_cast<std::int32_t>(power_30(divide_to_32(light, kMillion).quotient, 1, 3));
}

}  // namespace

Oklab oklab_of(const FineRgb& colour) {
    const std::int32_t red = linear_30(colour.red_8), green = linear_30(colour.green_8),
                       blue = linear_30(colour.blue_8);
    const std::int32_t long_30 = cone_response_30(kLongCone, red, green, blue),
                       middle_30 = cone_response_30(kMiddleCone, red, green, blue),
                       short_30 = cone_response_30(kShortCone, red, green, blue);
    const auto component_14 = [&](const Row& row) {
        return static_cast<std::int32_t>(row.times(long_30, middle_30, short_30) / (1 << 16) / kMillion);
    };
    return {component_14(kLightness), component_14(kGreenRed), component_14(kBlueYellow)};
}

}  // namespace oblong
