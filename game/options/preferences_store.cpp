#include "game/options/preferences_store.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <map>
#include <optional>
#include <utility>

#include "engine/base/input_error.h"
#include "engine/base/text.h"
#include "engine/io/files.h"
#include "engine/programs/arguments.h"

namespace oblong {
namespace {

/// NAME = VALUE. A NAME alone has the value "true", as a flag on a command line.
struct ConfigLine {
    std::string name, value;
    bool has_value = true;
    std::size_t number = 0;  // of the line, from 1
};

bool is_control_but_tab(char letter) {
    return (static_cast<unsigned char>(letter) < ' ' && letter != '\t') || letter == '\x7f';
}

std::string trimmed(const std::string& text) {
    const std::size_t begin = std::min(text.find_first_not_of(" \t\r"), text.size());
    return text.substr(begin, text.find_last_not_of(" \t\r") + 1 - begin);
}

std::string without_quotes(const std::string& text) {
    const std::string part = trimmed(text);
    const bool is_quoted = part.size() > 1 && part.front() == part.back() && (part[0] == '"' || part[0] == '\'');
    return is_quoted ? part.substr(1, part.size() - 2) : part;
}

// Nothing for an empty line or a comment, which begins with # or, at the beginning of a line, with ;
std::optional<ConfigLine> parse_config_line(const std::string& line, std::size_t number) {
    const std::string text = trimmed(line.substr(0, line.find('#')));
    if (text.empty() || text.front() == ';') return std::nullopt;
    const std::size_t equals = text.find('=');
    const bool has_value = equals != std::string::npos;
    const ConfigLine set{without_quotes(text.substr(0, equals)),
                         has_value ? without_quotes(text.substr(equals + 1)) : "true", has_value, number};
    if (set.name.empty() || text.front() == '[' || std::any_of(text.begin(), text.end(), is_control_but_tab))
        throw InputError("", "'" + text + "', expected NAME = VALUE");
    return set;
}

std::vector<std::string> lines_of_text(const std::string& text) {
    std::vector<std::string> lines = split(plain_text(text), "\n");
    if (lines.back().empty()) lines.pop_back();
    return lines;
}

std::string text_of_lines(const std::vector<std::string>& lines) {
    std::string text;
    for (const std::string& line : lines) text += line + '\n';
    return text;
}

/// Names that earlier versions wrote.
constexpr std::array kFormerNames{"light-set"};

bool is_known(const std::string& name, const std::span<const KeptValue* const> values) {
    return std::any_of(values.begin(), values.end(), [&](const KeptValue* value) { return value->name == name; });
}

// Behind an unknown name.
std::string what_is_expected(const ConfigLine& line) {
    const std::string expected =
        line.has_value ? " is unknown, expected a name that this version writes" : ", expected NAME = VALUE";
    return expected + "; the line is kept";
}

std::vector<ConfigLine> read_lines(const std::string& text, std::vector<LineFault>& faults) {
    const std::span<const KeptValue* const> values = all_kept_values();
    std::vector<ConfigLine> read;
    std::size_t number = 0;
    for (const std::string& line : lines_of_text(text)) {
        ++number;
        try {
            const std::optional<ConfigLine> set = parse_config_line(line, number);
            if (!set || std::find(kFormerNames.begin(), kFormerNames.end(), set->name) != kFormerNames.end()) continue;
            if (is_known(set->name, values))
                read.push_back(*set);
            else
                faults.push_back({number, printable("'" + set->name + "'" + what_is_expected(*set))});
        } catch (const InputError& error) {
            faults.push_back({number, error.what()});
        }
    }
    return read;
}

// An error message without the dashes of a command line.
std::string without_dashes(const std::string& what) {
    return printable(what.starts_with("--") ? what.substr(2) : what);
}

// Applies the lines of a name to the preferences.
void parse_lines(const KeptValue& value, const std::vector<ConfigLine>& lines, ReadPreferences& read) {
    std::size_t former = 0;
    for (const ConfigLine& line : lines) {
        if (line.name != value.name) continue;
        try {
            value.parse(read.preferences, line.value);
            if (former > 0)
                read.faults.push_back({line.number, "'" + value.name + "' is already set in line " +
                                                        std::to_string(former) +
                                                        ", expected each name once: this line counts"});
            former = line.number;
        } catch (const std::runtime_error& error) {
            read.faults.push_back({line.number, line.has_value ? without_dashes(error.what())
                                                               : "'" + value.name + "', expected NAME = VALUE"});
        }
    }
}

// Mode, field of view and display may each be valid but not together: then mode and field of view keep their defaults.
void check_together(const std::vector<ConfigLine>& lines, ReadPreferences& read) {
    try {
        check_view(read.preferences.mode, read.preferences.field_of_view);
    } catch (const UsageError& error) {
        const Preferences usual;
        read.preferences.mode = usual.mode;
        read.preferences.field_of_view = usual.field_of_view;
        const auto is_of_view = [](const ConfigLine& line) {
            return line.name == "mode" || line.name == "fov" || line.name == "display";
        };
        const auto last = std::find_if(lines.rbegin(), lines.rend(), is_of_view);
        read.faults.push_back({last->number, without_dashes(error.what())});
    }
}

void check_is_text(const std::string& text) {
    constexpr std::ptrdiff_t kMostControls = 16;  // up to this many: a damaged text
    const auto is_control = [](char letter) {
        return static_cast<unsigned char>(letter) < ' ' && letter != '\t' && letter != '\n' && letter != '\r';
    };
    const std::ptrdiff_t controls = std::count_if(text.begin(), text.end(), is_control);
    if (controls > kMostControls)
        throw InputError("text", std::to_string(controls) + " control characters, expected lines NAME = VALUE");
}

std::vector<std::string> commented(const KeptValue& value, const Preferences& preferences) {
    return {"", "# " + value.label + ": " + value.help + ".",
            "# " + value.values + "; default: " + value.text(Preferences{}),
            value.name + " = " + value.text(preferences)};
}

// A line with another value; its spaces and its comment are kept.
std::string with_value(const std::string& line, const std::string& value) {
    const std::size_t equals = line.find('=');
    if (equals == std::string::npos) return line.substr(0, line.find_last_not_of(" \t\r") + 1) + " = " + value;
    const std::size_t begin = std::min(line.find_first_not_of(" \t", equals + 1), line.size());
    const std::size_t comment = std::min(line.find('#', begin), line.size());
    const std::size_t last = comment == begin ? std::string::npos : line.find_last_not_of(" \t\r", comment - 1);
    const std::size_t end = last == std::string::npos || last < begin ? begin : last + 1;
    const std::string space = begin == equals + 1 ? " " : "";
    const std::string before_comment = end == comment && comment < line.size() ? " " : "";
    return line.substr(0, begin) + space + value + before_comment + line.substr(end);
}

// Keeps the first faults, and counts the rest.
void limit_faults(std::vector<LineFault>& faults) {
    constexpr std::size_t kMost = 16;
    if (faults.size() <= kMost) return;
    const std::size_t more = faults.size() - kMost, line = faults[kMost].line;
    faults.resize(kMost);
    faults.push_back({line, "this line and " + std::to_string(more - 1) + " others are wrong too"});
}

namespace fs = std::filesystem;

constexpr std::size_t kLargestFile_bytes = 256 * 1024;

bool exists(const std::string& file) {
    std::error_code error;
    return fs::exists(fs::symlink_status(file, error));
}

std::string text_of_file(const std::string& file) {
    const std::vector<std::uint8_t> bytes = read_file(file, kLargestFile_bytes);
    return {bytes.begin(), bytes.end()};
}

}  // namespace

ReadPreferences read_preferences(const std::string& text) {
    check_is_text(text);
    ReadPreferences read;
    const std::vector<ConfigLine> lines = read_lines(text, read.faults);
    for (const KeptValue* value : all_kept_values()) parse_lines(*value, lines, read);
    check_together(lines, read);
    std::stable_sort(read.faults.begin(), read.faults.end(),
                     [](const LineFault& a, const LineFault& b) { return a.line < b.line; });
    limit_faults(read.faults);
    return read;
}

std::string write_preferences(const Preferences& preferences) {
    std::vector<std::string> lines{
        "# Options of Oblong. The game changes values here and leaves all else as it is:",
        "# comments, order, and names that it does not know. A line that it can't read is named when it starts."};
    for (const KeptValue* value : all_kept_values()) {
        const std::vector<std::string> own = commented(*value, preferences);
        lines.insert(lines.end(), own.begin(), own.end());
    }
    return text_of_lines(lines);
}

std::string with_values(const std::string& text, const std::vector<const KeptValue*>& changed, const Preferences& now) {
    std::vector<LineFault> faults;
    std::map<std::string, std::size_t> line_of_name;  // the last one
    for (const ConfigLine& line : read_lines(text, faults)) line_of_name[line.name] = line.number;
    std::vector<std::string> lines = lines_of_text(text);
    for (const KeptValue* value : changed) {
        const auto found = line_of_name.find(value->name);
        if (found != line_of_name.end()) {
            std::string& line = lines[found->second - 1];
            line = with_value(line, value->text(now));
            continue;
        }
        const std::vector<std::string> own = commented(*value, now);
        lines.insert(lines.end(), own.begin(), own.end());
    }
    return text_of_lines(lines);
}

PreferencesStore::PreferencesStore(std::string file) : file_(std::move(file)) {
    if (!file_.empty() && exists(file_)) {
        try {
            const std::string text = text_of_file(file_);
            ReadPreferences read = naming_file(file_, [&] { return read_preferences(text); });
            kept_ = read.preferences;
            for (const LineFault& fault : read.faults)
                faults_.push_back(file_ + ": line " + std::to_string(fault.line) + ": " + fault.what);
        } catch (const FileError& error) {
            faults_.push_back(std::string(error.what()) + "; options are not kept");
            file_.clear();
        }
    }
    begin_with(kept_);
}

// A preset changes its dials too, so kept and earlier preferences are compared after all changes are copied.
void PreferencesStore::note_changes(const Preferences& now) {
    const Preferences before = kept_;
    for (const KeptValue* value : all_kept_values()) {
        const std::string text = value->text(now);
        if (text != value->text(shown_)) value->parse(kept_, text);
    }
    shown_ = now;
    for (const KeptValue* value : all_kept_values()) {
        const bool is_listed = std::find(changed_.begin(), changed_.end(), value) != changed_.end();
        if (!is_listed && value->text(kept_) != value->text(before)) changed_.push_back(value);
    }
}

std::string PreferencesStore::save(const Preferences& now) {
    if (file_.empty()) return "";
    note_changes(now);
    if (changed_.empty()) return "";
    try {
        const std::string folder = fs::path(file_).parent_path().string();
        if (!folder.empty()) make_folder(folder);
        // The file may have been edited while the game ran.
        const std::string text = exists(file_) ? text_of_file(file_) : write_preferences(kept_);
        write_file(file_, with_values(text, changed_, kept_), FileUse::Kept);
        changed_.clear();
        return "";
    } catch (const FileError& error) {
        return error.what();
    }
}

std::string PreferencesStore::save_when_settled(const Preferences& now, std::uint64_t now_us) {
    constexpr std::uint64_t kSettles_us = 1'000'000;
    if (now != settled_) {
        settled_ = now;
        settled_us_ = now_us;
    }
    if (settled_ == shown_ || now_us - settled_us_ < kSettles_us) return "";
    return save(now);
}

}  // namespace oblong
