#include "engine/programs/arguments.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <new>
#include <optional>

#include "engine/accuracy/accuracy.h"
#include "engine/base/text.h"
#include "engine/io/files.h"
#include "engine/view/projection.h"

namespace oblong {

namespace {

/// The names of rows, with commas between them.
template <class Rows>
std::string row_names(const Rows& rows) {
    std::string names;
    for (const auto& row : rows) names += (names.empty() ? "" : ", ") + std::string(row.name);
    return names;
}

std::optional<std::int32_t> whole_number(const std::string& text) {
    std::int32_t value = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (error != std::errc{} || end != text.data() + text.size()) return std::nullopt;
    return value;
}

/// "320x200", both from `least` to `most`. Throws UsageError(expected).
WindowSize parse_size(const std::string& text, std::int32_t least, std::int32_t most, const std::string& expected) {
    const std::size_t at = text.find('x');
    const auto first = at == std::string::npos ? std::nullopt : whole_number(text.substr(0, at));
    const auto second = at == std::string::npos ? std::nullopt : whole_number(text.substr(at + 1));
    const auto fits = [&](std::optional<std::int32_t> value) { return value && *value >= least && *value <= most; };
    if (!fits(first) || !fits(second)) throw UsageError(expected);
    return {*first, *second};
}

/// A decimal number above 0 with up to four decimals, exactly.
std::optional<Ratio> decimal_ratio(std::string text) {
    const std::size_t point = std::min(text.find('.'), text.size());
    const bool is_whole = point == text.size();
    if (!is_whole) text.erase(point, 1);
    const std::optional<std::int32_t> digits = whole_number(text);
    const std::size_t decimals = text.size() - point;
    if (!digits || *digits <= 0 || point == 0 || (!is_whole && decimals == 0) || decimals > 4) return std::nullopt;
    constexpr std::array<std::int64_t, 5> kPowers{1, 10, 100, 1000, 10000};
    return Ratio{*digits, kPowers[decimals]};
}

}  // namespace

std::string listed(std::span<const std::string_view> names) {
    std::string text;
    for (std::size_t i = 0; i < names.size(); ++i)
        text += (i == 0 ? "" : i + 1 == names.size() ? " or " : ", ") + std::string(names[i]);
    return text;
}

std::size_t parse_choice(const std::string& option, const std::string& text, std::span<const std::string_view> names) {
    const auto found = std::find(names.begin(), names.end(), text);
    if (found == names.end()) throw UsageError(option + ": '" + text + "', expected " + listed(names));
    return static_cast<std::size_t>(found - names.begin());
}

void parse_mode_size(const std::string& text, ScreenMode& mode) {
    const std::string expected = "--mode: '" + text + "', expected WIDTHxHEIGHT from 8x8 to " +
                                 std::to_string(kLargestMode_px) + "x" + std::to_string(kLargestMode_px);
    const WindowSize size = parse_size(text, 8, kLargestMode_px, expected);
    mode.width_px = size.width_px;
    mode.height_px = size.height_px;
}

WindowSize parse_window_size(const std::string& text) {
    return parse_size(text, 1, 16384, "--window: '" + text + "', expected WIDTHxHEIGHT from 1x1 to 16384x16384");
}

Ratio parse_display(const std::string& text) {
    const std::size_t colon = std::min(text.find(':'), text.size() - 1);
    const auto width = decimal_ratio(text.substr(0, colon)), height = decimal_ratio(text.substr(colon + 1));
    const Ratio shape = width && height ? *width * height->inverse() : Ratio{};
    const std::int64_t least = std::min(shape.numerator, shape.denominator),
                       most = std::max(shape.numerator, shape.denominator);
    if (least > 0 && most <= 100 * least && most <= 10000) return shape;
    throw UsageError(
        "--display: '" + text +
        "', expected WIDTH:HEIGHT from 1:100 to 100:1, such as 4:3 or 1.85:1; as whole numbers up to 10000");
}

std::int64_t parse_number(const std::string& option, const std::string& text, int fraction_bits) {
    const std::optional<std::int64_t> raw = parse_decimal(text, fraction_bits);
    if (raw && std::abs(*raw) < std::int64_t{1} << (24 + fraction_bits)) return *raw;
    throw UsageError(option + ": '" + text + "', expected a decimal number between -16,777,216 and 16,777,216");
}

Degrees parse_field_of_view(const std::string& text) {
    const std::optional<std::int64_t> raw_32 = parse_decimal(text, 32);
    if (!raw_32 || *raw_32 < std::int64_t{1} << 32 || *raw_32 > std::int64_t{179} << 32)
        throw UsageError("--fov: '" + text + "', expected 1 to 179 degrees");
    return Degrees::from_raw(*raw_32 << 16);
}

std::int32_t parse_brightness(const std::string& text) {
    constexpr std::int64_t kOne_16 = 1 << 16;
    const std::optional<std::int64_t> raw_16 = parse_decimal(text, 16);
    if (!raw_16 || *raw_16 < kOne_16 / 4 || *raw_16 > kOne_16 * 8)
        throw UsageError("--brightness: '" + text + "', expected 0.25 to 8");
    return static_cast<std::int32_t>((*raw_16 * 100 + kOne_16 / 2) / kOne_16);
}

const Kernels& parse_instructions(const std::string& text) {
    const Kernels* const kernels = text.empty() ? &best_kernels() : find_kernels(text);
    if (!kernels) throw UsageError("--instructions: '" + text + "', expected one of " + row_names(all_kernels()));
    return *kernels;
}

std::string instructions_help() {
    return "the instructions that draw: " + row_names(all_kernels()) + " (default: the first); the picture is the same";
}

void check_view(const ScreenMode& mode, Degrees field_of_view) {
    if (is_drawable(make_projection(mode, field_of_view))) return;
    throw UsageError("--mode: '" + std::to_string(mode.width_px) + "x" + std::to_string(mode.height_px) +
                     "' has too few pixels for such a field of view on such a display, expected a larger mode, a "
                     "narrower view or a display nearer to the mode's shape");
}

Preset parse_preset(const std::string& text) {
    if (const std::optional<Preset> preset = preset_named(text)) return *preset;
    throw UsageError("--accuracy: '" + text + "', expected " + std::string(kPresetNames));
}

namespace {

std::optional<std::int32_t> dial_value(const Dial& dial, const std::string& text) {
    for (const DialSetting& setting : dial.settings)
        if (setting.name == text) return setting.value;
    if (dial.least == dial.greatest) return std::nullopt;
    const std::optional<std::int64_t> number = parse_decimal(text, dial.fraction_bits);
    if (!number || *number < dial.least || *number > dial.greatest) return std::nullopt;
    return static_cast<std::int32_t>(*number);
}

}  // namespace

std::string values_of(const Dial& dial) {
    const std::string text = row_names(dial.settings);
    if (dial.least == dial.greatest) return text;
    return text + ", or any from " + value_text(dial, dial.least) + " to " + value_text(dial, dial.greatest);
}

void parse_dial(const std::string& text, Accuracy& accuracy) {
    const std::size_t equals = text.find('=');
    if (equals == std::string::npos) throw UsageError("--dial: '" + text + "', expected NAME=VALUE");
    const std::string name = text.substr(0, equals), value = text.substr(equals + 1);
    const Dial* const dial = dial_named(name);
    if (!dial) throw UsageError("--dial: '" + name + "', expected one of " + row_names(all_dials()));
    const std::optional<std::int32_t> number = dial_value(*dial, value);
    if (!number) throw UsageError("--dial: '" + text + "', expected one of " + values_of(*dial));
    dial->set(accuracy, *number);
}

Accuracy parse_accuracy(Preset preset, const std::vector<std::string>& dials) {
    Accuracy accuracy = accuracy_of(preset);
    for (const std::string& dial : dials) parse_dial(dial, accuracy);
    return accuracy;
}

std::string message_of(const std::exception& error) {
    if (const auto* input = dynamic_cast<const InputError*>(&error)) return input->where + ": " + input->what();
    if (dynamic_cast<const std::bad_alloc*>(&error) != nullptr) return "out of memory";
    return error.what();
}

int run_program(const std::string& name, const std::function<void()>& body) {
    try {
        body();
        flush_standard_output();
        return 0;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "%s: %s\n", name.c_str(), message_of(error).c_str());
        return dynamic_cast<const UsageError*>(&error) != nullptr ? 2 : 1;
    }
}

void print_fault(const std::string& program, const std::string& fault) {
    if (!fault.empty()) std::fprintf(stderr, "%s: %s\n", program.c_str(), fault.c_str());
}

void print_warnings(const std::string& program, const std::string& level_file,
                    const std::vector<std::string>& warnings) {
    for (const std::string& warning : warnings)
        std::fprintf(stderr, "%s: %s: warning: %s\n", program.c_str(), level_file.c_str(), warning.c_str());
}

void warn_of_torn_edges(const std::string& program, const std::string& level_file, std::size_t edges) {
    if (edges == 0) return;
    std::fprintf(stderr,
                 "%s: %s: warning: the level is torn at %zu edges, expected faces that meet: where one is "
                 "missing, the texture of another goes on\n",
                 program.c_str(), level_file.c_str(), edges);
}

}  // namespace oblong
