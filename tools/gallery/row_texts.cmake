# The rows' texts are compiled into the program.
set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/rows.txt)
file(READ ${CMAKE_CURRENT_LIST_DIR}/rows.txt ROW_TEXTS)
file(CONFIGURE OUTPUT include/tools/gallery/row_texts.h @ONLY CONTENT [[
#pragma once

#include <string_view>

inline constexpr std::string_view kRowTexts = R"rows(@ROW_TEXTS@)rows";
]])
