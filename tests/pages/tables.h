#pragma once

#include <string>
#include <string_view>

namespace oblong::test {

inline std::string code(std::string_view text) {
    return "`" + std::string(text) + "`";
}

/// Tables in Markdown, made from the tables that the code itself reads.
std::string action_table();
std::string option_table();
std::string dial_table();
std::string class_table();
std::string entity_key_table();
std::string left_out_table();
/// What oblong.h declares, and what the examples show.
std::string library_table();
std::string first_program();
std::string input_table();
/// The members of game.json.
std::string game_member_table();
std::string example_table();

}  // namespace oblong::test
