#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <string>

#include "tests/support/script.h"

namespace oblong::test {

/// Whether a number is as the words of a check say: "x = 3", "x = 17.5 +- 1", "x < 3", "x > 3".
inline testing::AssertionResult holds(const Words& check, double found) {
    const double wanted = std::stod(check.at(2)), tolerance = check.size() > 4 ? std::stod(check[4]) : 0;
    const std::string& sign = check[1];
    if (sign == "=" ? std::abs(found - wanted) <= tolerance : sign == "<" ? found < wanted : found > wanted)
        return testing::AssertionSuccess();
    return testing::AssertionFailure() << joined(check) << ": is " << found;
}

}  // namespace oblong::test
