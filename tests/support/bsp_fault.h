#pragma once

#include <gtest/gtest.h>

#include <string>

#include "engine/base/input_error.h"
#include "engine/level/bsp_read.h"
#include "tests/support/bsp_writer.h"

namespace oblong::test {

/// Where read_bsp finds fault; empty if it reads a level.
inline std::string fault_of(const Bytes& file) {
    try {
        read_bsp(file);
        return "";
    } catch (const InputError& error) {
        EXPECT_NE(std::string(error.what()), "");
        return error.where;
    }
}

inline std::string lump_label(std::size_t lump) {
    return "lump '" + std::string(kLumpNames[lump]) + "'";
}

inline bool names_a_lump(const std::string& where) {
    for (std::size_t lump = 0; lump < kLumpCount; ++lump)
        if (where.starts_with(lump_label(lump) + ", offset ")) return true;
    return false;
}

}  // namespace oblong::test
