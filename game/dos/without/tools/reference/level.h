#pragma once

#include <cstdint>
#include <stdexcept>
#include <vector>

// The reference renderer computes with doubles and integers of 128 bits, which an i486 lacks: the lab says so instead
// of showing an error. Found before the header of the same name.

namespace oblong::reference {

struct Level {};

inline Level read_level(const std::vector<std::uint8_t>&) {
    throw std::runtime_error("errors are not measured under DOS");
}

}  // namespace oblong::reference
