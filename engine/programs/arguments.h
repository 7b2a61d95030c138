#pragma once

#include <functional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

#include "engine/accuracy/accuracy.h"
#include "engine/fixed/trig.h"
#include "engine/raster/kernels/kernels.h"
#include "engine/view/present_rect.h"
#include "engine/view/screen.h"

namespace oblong {

/// An invalid argument: programs print the message and exit with 2.
class UsageError : public std::runtime_error {
  public:
    using std::runtime_error::runtime_error;
};

/// "naive, dda or bresenham".
std::string listed(std::span<const std::string_view> names);
/// The index of a name. Throws UsageError that begins with `option` and lists the names for another text.
std::size_t parse_choice(const std::string& option, const std::string& text, std::span<const std::string_view> names);
/// "320x200" into `mode`'s size; from 8x8 to the largest mode.
void parse_mode_size(const std::string& text, ScreenMode& mode);
/// "1280x960"; up to 16,384 pixels either way.
WindowSize parse_window_size(const std::string& text);
/// "4:3", "1.85:1".
Ratio parse_display(const std::string& text);
/// A field of view in degrees, decimal, from 1 to 179.
Degrees parse_field_of_view(const std::string& text);
/// The brightness of lit surfaces, decimal, from 0.25 to 8; returned in hundredths.
std::int32_t parse_brightness(const std::string& text);
/// The kernels of an instruction set by name; empty: the best that this processor has.
const Kernels& parse_instructions(const std::string& text);
/// What --instructions does, with the names that it takes on this processor.
std::string instructions_help();
/// Throws UsageError for values that are valid alone but not together: a wide field of view in a mode of few pixels.
void check_view(const ScreenMode& mode, Degrees field_of_view);
/// One of kPresetNames.
Preset parse_preset(const std::string& text);
/// The values of a dial: "off, on", "16, 32, 64, or any from 12 to 44".
std::string values_of(const Dial& dial);
/// Sets a dial by "NAME=VALUE" (engine/accuracy/accuracy.h).
void parse_dial(const std::string& text, Accuracy& accuracy);
/// A preset with changed dials: the values of --accuracy and all --dial.
Accuracy parse_accuracy(Preset preset, const std::vector<std::string>& dials);
/// A decimal number such as "-12.375" as raw units of 2^-fraction_bits (0 to 32), rounded to the nearest; |value| below
/// 2^24. Throws UsageError that begins with `option` for anything else, "nan" and "1e3" included.
std::int64_t parse_number(const std::string& option, const std::string& text, int fraction_bits);

/// A program's message for an error, without its name.
std::string message_of(const std::exception& error);

/// Runs a program's body, checks that its standard output was written, and reports exceptions and returns an exit code:
/// 0 success; 1 a failure, `PROGRAM: FILE: WHERE: what is wrong` on standard error; 2 wrong usage.
int run_program(const std::string& name, const std::function<void()>& body);

/// Prints a fault that does not end the program on standard error, `PROGRAM: FAULT`; nothing if it is empty.
void print_fault(const std::string& program, const std::string& fault);

/// Prints warnings about a level on standard error, a line each.
void print_warnings(const std::string& program, const std::string& level_file,
                    const std::vector<std::string>& warnings);

/// Warns on standard error that faces of a level do not meet at some edges; prints nothing if `edges` is 0.
void warn_of_torn_edges(const std::string& program, const std::string& level_file, std::size_t edges);

}  // namespace oblong
