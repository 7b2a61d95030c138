#pragma once

#include <string>

namespace oblong::test {

/// Tables in Markdown, made from the tables that the code itself reads.
std::string action_table();
std::string option_table();
std::string dial_table();
std::string class_table();
std::string entity_key_table();

}  // namespace oblong::test
