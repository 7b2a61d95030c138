#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "engine/fixed/fixed.h"
#include "engine/math/soft_float.h"

namespace oblong {

/// A decimal number such as "-12.375" or "1e-05" in units of 2^-fraction_bits, found without floating point.
struct ParsedFixed {
    std::int64_t raw = 0;   ///< to the nearest
    bool is_exact = false;  ///< the decimal number is a whole number of units
};

/// None for what is not a decimal number, and where |value| is 2^(62 - fraction_bits) or more. `fraction_bits` 0 to 48.
std::optional<ParsedFixed> parse_fixed(std::string_view text, int fraction_bits);

/// The same with 62 significant bits, of up to 18 decimals; below 10^18.
std::optional<SoftFloat> parse_scaled(std::string_view text);

/// raw / 2^fraction_bits with all its decimals, of which a binary fraction has finitely many. `fraction_bits` 0 to 60.
std::string format_fixed(std::int64_t raw, int fraction_bits);

template <class Int, int Frac>
std::string format_fixed(Fixed<Int, Frac> value) {
    return format_fixed(value.raw, Frac);
}

}  // namespace oblong
