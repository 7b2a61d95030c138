#pragma once

#include <gtest/gtest.h>

#include <cstdint>
#include <span>

namespace oblong::test {

/// Whether two pictures of so many pixels a row are the same. If they are not, both and their difference (white: other
/// pixels) are written as PNG files below the build folder; the message names them, and says how many pixels differ and
/// which is the first.
testing::AssertionResult same_picture(std::span<const std::uint8_t> found, std::span<const std::uint8_t> expected,
                                      std::size_t width = 320);

}  // namespace oblong::test
