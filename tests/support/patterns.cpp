#include "tests/support/patterns.h"

#include <map>
#include <regex>

namespace oblong::test {

namespace {

/// Made once for each pattern: some are matched with every line of the sources.
const std::regex& expression(const std::string& pattern) {
    static std::map<std::string, std::regex> made;
    return made.try_emplace(pattern, pattern).first->second;
}

Groups groups_of(const std::smatch& match) {
    Groups groups;
    for (const auto& group : match) groups.push_back(group.str());
    return groups;
}

}  // namespace

bool is_found(const std::string& text, const std::string& pattern) {
    return std::regex_search(text, expression(pattern));
}

Groups whole_match(const std::string& text, const std::string& pattern) {
    std::smatch match;
    return std::regex_match(text, match, expression(pattern)) ? groups_of(match) : Groups{};
}

std::vector<Groups> all_matches(const std::string& text, const std::string& pattern) {
    std::vector<Groups> matches;
    for (std::sregex_iterator at(text.begin(), text.end(), expression(pattern)), end; at != end; ++at)
        matches.push_back(groups_of(*at));
    return matches;
}

std::string with_replaced(const std::string& text, const std::string& pattern, const std::string& replacement) {
    return std::regex_replace(text, expression(pattern), replacement);
}

}  // namespace oblong::test
