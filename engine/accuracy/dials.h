#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/accuracy/accuracy.h"

namespace oblong {

/// One position of a dial.
struct DialSetting {
    std::string_view name;  ///< as in `--dial NAME=VALUE`
    std::int32_t value;
};

/// One field of Accuracy, with its name and values.
struct Dial {
    std::string_view name;     ///< as in `--dial NAME=VALUE`
    std::string_view caption;  ///< at most 20 characters, for the screen
    std::string_view about;    ///< one or two sentences
    std::string_view unit;     ///< empty if its values have names
    std::string_view read_in;  ///< the file that reads it from Accuracy
    /// Whether another setting changes the work done. If not, a value is only rounded to fewer bits in a wide type: its
    /// error is real, but its time is that of the wide type; the cost of a narrow type can only be modelled.
    bool changes_work;
    std::span<const DialSetting> settings;  ///< from the coarsest to the most exact
    /// Numbers from `least` to `greatest`, in steps of 2^-fraction_bits, are valid too, unless both are 0.
    std::int32_t least, greatest;
    int fraction_bits;
    std::int32_t (*get)(const Accuracy&);
    void (*set)(Accuracy&, std::int32_t);
};

/// All dials, in the order of the stages that read them.
std::span<const Dial> all_dials();
/// Null if there is none.
const Dial* dial_named(std::string_view name);

/// The name of a value, or its number: "every16", "0.375".
std::string value_text(const Dial& dial, std::int32_t value);
/// Moves a dial from the setting nearest to its value by `steps` toward the exact end (negative: the coarse end); stops
/// at the ends.
void turn(const Dial& dial, int steps, Accuracy& accuracy);

}  // namespace oblong
