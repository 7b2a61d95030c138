#include <cctype>
#include <map>
#include <set>
#include <string_view>

#include "tests/architecture/source_checks.h"
#include "tests/support/patterns.h"

namespace oblong::test {

namespace {

bool is_of_name(char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 || letter == '_';
}

/// The code of a file: no comments, and empty texts.
std::string code_of(const std::string& text) {
    return with_replaced(text, R"re(//[^\n]*|"(\\.|[^"\\\n])*")re", "");
}

struct Name {
    std::string_view code;
    std::size_t begin, end;

    std::string text() const { return std::string(code.substr(begin, end - begin)); }
    bool is_called() const { return end < code.size() && code[end] == '('; }

    /// Whether a type stands before it, as in a declaration or a definition: "Plane* name", "std::vector<int> name".
    bool follows_type() const {
        std::size_t before = begin;
        while (before > 0 && std::isspace(static_cast<unsigned char>(code[before - 1])) != 0) --before;
        if (before == 0 || before == begin) return false;
        std::size_t end_of_type = before;
        while (end_of_type > 0 && (code[end_of_type - 1] == '&' || code[end_of_type - 1] == '*')) --end_of_type;
        if (end_of_type == 0) return false;
        const char last = code[end_of_type - 1];
        if (last == '>' || last == ']') return true;
        std::size_t start = end_of_type;
        while (start > 0 && is_of_name(code[start - 1])) --start;
        const std::string_view word = code.substr(start, end_of_type - start);
        return !word.empty() && word != "return" && word != "else" && word != "case" && word != "throw";
    }

    /// Whether it is "Class::name(" in a line that begins at the margin: a member's definition.
    bool is_member_definition() const {
        if (begin < 2 || code.substr(begin - 2, 2) != "::") return false;
        const std::size_t line = code.rfind('\n', begin) + 1;  // npos + 1 is 0
        return is_of_name(code[line]);
    }
};

std::vector<Name> names_of(std::string_view code) {
    std::vector<Name> names;
    for (std::size_t at = 0; at < code.size();) {
        std::size_t end = at;
        while (end < code.size() && is_of_name(code[end])) ++end;
        if (end > at) names.push_back({code, at, end});
        at = end + 1;
    }
    return names;
}

bool is_asked_for(const std::string& path) {
    return path.starts_with("engine/") && path.ends_with(".h") && !path.starts_with("engine/methods/");
}

}  // namespace

std::vector<std::string> find_unused_functions(const std::vector<SourceFile>& files) {
    std::map<std::string, std::string> declared;
    std::set<std::string> used;
    for (const SourceFile& file : files) {
        if (file.path.starts_with("tools/gallery/") || file.path.starts_with("tools/probe/")) continue;
        const std::string code = code_of(file.text);
        for (const Name& name : names_of(code)) {
            const bool is_declared = name.is_called() && name.follows_type() && name.text() != "__attribute__";
            if (is_declared && is_asked_for(file.path)) declared.emplace(name.text(), file.path);
            if (!is_declared && !(name.is_called() && name.is_member_definition())) used.insert(name.text());
        }
    }
    std::vector<std::string> faults;
    for (const auto& [name, path] : declared)
        if (used.count(name) == 0) faults.push_back(path + ": " + name + " is used by no program");
    return faults;
}

}  // namespace oblong::test
