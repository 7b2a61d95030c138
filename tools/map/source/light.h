#pragma once

#include <algorithm>
#include <array>
#include <cmath>

namespace oblong::map {

/// Light of some colour, or the shares of it that a surface reflects.
struct Light {
    double luminance = 0;              ///< BT.601
    std::array<double, 3> channels{};  ///< red, green and blue; in white light each is the luminance

    Light& operator+=(const Light& other) {
        return combine(other, [](double own, double others) { return own + others; });
    }
    Light& operator*=(const Light& other) {
        return combine(other, [](double own, double others) { return own * others; });
    }
    Light& operator*=(double factor) { return *this *= Light{factor, {factor, factor, factor}}; }
    Light& operator/=(double divisor) {
        return combine({}, [divisor](double own, double) { return own / divisor; });
    }
    /// The brighter of each.
    Light& raise_to(const Light& other) {
        return combine(other, [](double own, double others) { return std::max(own, others); });
    }
    double brightest() const { return std::max(luminance, *std::max_element(channels.begin(), channels.end())); }
    bool is_white() const {
        constexpr double kRounding = 1e-9;
        return std::all_of(channels.begin(), channels.end(),
                           [&](double channel) { return std::abs(channel - luminance) <= kRounding * luminance; });
    }
    bool operator==(const Light&) const = default;

  private:
    Light& combine(const Light& other, auto combined) {
        luminance = combined(luminance, other.luminance);
        for (std::size_t i = 0; i < channels.size(); ++i) channels[i] = combined(channels[i], other.channels[i]);
        return *this;
    }
};

/// The channels of light of luminance 1.
struct Hue {
    std::array<double, 3> channels{1, 1, 1};

    Light of(double luminance) const {
        return {luminance, {channels[0] * luminance, channels[1] * luminance, channels[2] * luminance}};
    }
    bool is_white() const { return of(1).is_white(); }
};

}  // namespace oblong::map
