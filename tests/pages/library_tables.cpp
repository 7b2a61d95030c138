#include <algorithm>
#include <filesystem>
#include <sstream>

#include "engine/io/files.h"
#include "engine/platform/input.h"
#include "tests/pages/tables.h"
#include "tests/support/folders.h"

namespace oblong::test {
namespace {

namespace fs = std::filesystem;

bool take(std::string& text, std::string_view beginning) {
    const bool is_there = text.starts_with(beginning);
    if (is_there) text.erase(0, beginning.size());
    return is_there;
}

/// Without what is said of a word to the compiler alone.
std::string signature_of(std::string text) {
    for (const std::string_view word : {"std::", "explicit ", "inline constexpr "})
        for (std::size_t at = text.find(word); at != text.npos; at = text.find(word)) text.erase(at, word.size());
    text.erase(text.ends_with(';') ? text.size() - 1 : text.find(" {"));
    return text;
}

std::string first_sentence(std::string text) {
    text.erase(std::min(text.find(". "), text.size()));
    if (text.ends_with('.')) text.pop_back();
    return text;
}

/// A header's declarations, each with the first sentence above or beside it.
class HeaderReader {
  public:
    void read_line(std::string line) {
        const bool is_at_margin = !line.starts_with(' ');
        line.erase(0, std::min(line.find_first_not_of(' '), line.size()));
        if (take(line, "/// "))
            about_ += (about_.empty() ? "" : " ") + line;
        else if (is_at_margin && take(line, "// ")) {
            end_row();
            table_ += "\n**" + line + "**\n\n| | |\n|---|---|\n";
        } else if (line.ends_with("public:") || line.ends_with("private:"))
            is_public_ = line == "public:";
        else if (line.starts_with("}"))
            is_public_ = true;
        else if (line.empty())
            about_.clear();
        else if (!line.starts_with("//"))
            read_code(line);
    }
    const std::string& table() {
        end_row();
        return table_;
    }

  private:
    void read_code(std::string line) {
        const std::size_t beside = line.find("  ///< ");
        if (beside != line.npos) about_ += line.substr(beside + 7);
        line.erase(std::min(beside, line.size()));
        declaration_ += (declaration_.empty() ? "" : " ") + line;
        if (!line.ends_with(';') && !line.ends_with('{') && !line.ends_with('}')) return;
        const std::string whole = std::exchange(declaration_, "");
        const bool is_type = whole.starts_with("class ") || whole.starts_with("struct ");
        const bool is_for_compilers = whole.find("= delete") != whole.npos || whole.find("operator") != whole.npos ||
                                      whole.find("&& other)") != whole.npos || whole.starts_with('~') ||
                                      (is_type && !whole.ends_with('{'));
        if (is_public_ && !is_for_compilers) {
            if (!about_.empty()) end_row();
            row_ += (row_.empty() ? "" : "<br>") + code(signature_of(whole));
            if (!about_.empty()) row_about_ = first_sentence(about_);
        }
        if (is_type && whole.ends_with('{')) is_public_ = whole.starts_with("struct ");
        about_.clear();
    }
    void end_row() {
        if (!row_.empty()) table_ += "| " + row_ + " | " + row_about_ + " |\n";
        row_.clear();
    }

    std::string table_ = "| | |\n|---|---|\n", about_, declaration_, row_, row_about_;
    bool is_public_ = true;
};

/// The paragraph at the beginning of a source.
std::string first_comment(const std::string& source) {
    std::istringstream lines(source);
    std::string text;
    for (std::string line; std::getline(lines, line) && take(line, "// ");) text += (text.empty() ? "" : " ") + line;
    return text;
}

std::vector<fs::path> files_in(const fs::path& folder, const std::string& beginning, const std::string& extension) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(folder))
        if (entry.path().extension() == extension && entry.path().filename().string().starts_with(beginning))
            files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    return files;
}

}  // namespace

std::string library_table() {
    std::istringstream lines(read_text(source_folder() + "/engine/library/oblong.h"));
    std::string line;
    while (std::getline(lines, line) && line != "namespace oblong {") {
    }
    HeaderReader reader;
    while (std::getline(lines, line)) reader.read_line(line);
    return reader.table();
}

/// Indented, so that a page shows it as code; tests/consumer builds it.
std::string first_program() {
    std::istringstream lines(read_text(source_folder() + "/tests/consumer/first/game.cpp"));
    std::string text = "\n";
    for (std::string line; std::getline(lines, line);) text += (line.empty() ? "" : "    ") + line + "\n";
    return text + "\n";
}

/// All that have a name of their own; others are called by a number.
std::string input_table() {
    std::string text = "| | |\n|---|---|\n";
    const auto add_row = [&](const std::string& label, const std::vector<Device>& devices) {
        std::string names;
        for (const Device device : devices)
            for (std::uint16_t number = 0; number < 512; ++number) {
                const std::string name = name_of({device, number}), last = std::to_string(number);
                if (name != "Key " + last && name != "Wheel " + last && name != "Pad " + last)
                    names += (names.empty() ? "" : ", ") + name;
            }
        text += "| " + label + " | " + names + " |\n";
    };
    add_row("keys, by a US keyboard", {Device::Key});
    text += "| others | Key 1 to Key 511, by USB |\n| mouse | Mouse 1 (left), Mouse 2 (right), Mouse 3 to Mouse 31 |\n";
    add_row("wheel", {Device::MouseWheel});
    add_row("gamepad", {Device::PadButton, Device::PadAxis});
    return text;
}

std::string example_table() {
    std::string text = "| picture | example | shows |\n|---|---|---|\n";
    const fs::path folder = source_folder() + "/engine/examples";
    for (const fs::path& file : files_in(folder, "", ".cpp")) {
        const std::string name = file.stem().string();
        text += "| ";
        const std::vector<fs::path> pictures = files_in(folder, name, ".png");
        for (const fs::path& picture : pictures)
            text += "<img src=\"" + picture.filename().string() + "\" width=\"" +
                    (pictures.size() == 1 ? "320\" height=\"240" : "160\" height=\"120") + "\">";
        text += " | [" + name + "](" + name + ".cpp) | " + first_comment(read_text(file.string())) + " |\n";
    }
    return text;
}

}  // namespace oblong::test
