#pragma once

#include <string>
#include <vector>

/// Regular expressions, in ECMAScript's grammar. <regex> takes three seconds to compile wherever it is included: only
/// patterns.cpp does.
namespace oblong::test {

/// The groups of a match: [0] is the whole of it. A group that took no part is empty.
using Groups = std::vector<std::string>;

/// Whether it matches somewhere.
bool is_found(const std::string& text, const std::string& pattern);

/// The match of the whole text; empty without one.
Groups whole_match(const std::string& text, const std::string& pattern);

/// One after the other.
std::vector<Groups> all_matches(const std::string& text, const std::string& pattern);

/// The text with each match replaced.
std::string with_replaced(const std::string& text, const std::string& pattern, const std::string& replacement);

}  // namespace oblong::test
