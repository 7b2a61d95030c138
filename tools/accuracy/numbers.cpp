#include "tools/accuracy/numbers.h"

#include <cmath>
#include <cstdio>
#include <cstdlib>

namespace oblong {

namespace {

std::string with_commas(std::string digits) {
    for (std::size_t at = digits.size(); at > 3; at -= 3) digits.insert(at - 3, ",");
    return digits;
}

}  // namespace

std::string number_text(double value) {
    if (value == 0) return "0";
    const double size = std::abs(value);
    if (size < 1e-5) return "below 0.00001";
    char rounded[16];
    std::snprintf(rounded, sizeof rounded, "%.2e", size);  // 9.999 has two digits before the point, not one
    const int digits = std::atoi(rounded + 5) + 1;
    if (digits >= 3) {
        const double unit = std::pow(10, digits - 3);
        const std::string whole =
            std::to_string(static_cast<long long>(std::llround(size / unit) * std::llround(unit)));
        return (value < 0 ? "-" : "") + with_commas(whole);
    }
    char text[40];
    std::snprintf(text, sizeof text, "%.*f", 3 - digits, value);
    return text;
}

std::string short_number_text(double value) {
    std::string text = number_text(value);
    if (text.find('.') == std::string::npos) return text;
    text.resize(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

std::string microseconds_text(double nanoseconds) {
    return number_text(nanoseconds / 1000) + " \u00b5s";
}

}  // namespace oblong
