#pragma once

#include <cmath>
#include <cstdint>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "tools/probe/probe.h"

/// Each hard case is a test suite HardCaseLETTERNUMBER: README.md lists them. Many ask through the probe, as checks
/// from outside do.
namespace oblong::test {

inline std::string ask(const std::string& line) {
    return Probe().answer(line);
}

/// The numbers of an answer; none where it is a word.
inline std::vector<double> ask_numbers(const std::string& line) {
    std::istringstream in(ask(line));
    std::vector<double> numbers;
    for (double number; in >> number;) numbers.push_back(number);
    return numbers;
}

/// Fields separated by spaces.
template <class... Values>
std::string join(const Values&... values) {
    std::ostringstream out;
    out.precision(12);
    std::size_t index = 0;
    ((out << (index++ ? " " : "") << values), ...);
    return out.str();
}

/// The nearest multiple of 1/256: what lengths of queries are.
inline double snapped(double value) {
    return std::nearbyint(value * 256) / 256;
}

inline double random_between(std::mt19937& random, double low, double high) {
    return std::uniform_real_distribution<double>(low, high)(random);
}

inline std::int32_t random_integer(std::mt19937& random, std::int32_t low, std::int32_t high) {
    return std::uniform_int_distribution<std::int32_t>(low, high)(random);
}

}  // namespace oblong::test
