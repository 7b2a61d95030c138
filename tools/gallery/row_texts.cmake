# The rows' texts and the index page are compiled into the program.
foreach(NAME rows.txt page.html)
    set_property(DIRECTORY APPEND PROPERTY CMAKE_CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/${NAME})
endforeach()
file(READ ${CMAKE_CURRENT_LIST_DIR}/rows.txt ROW_TEXTS)
file(READ ${CMAKE_CURRENT_LIST_DIR}/page.html PAGE)
file(CONFIGURE OUTPUT include/tools/gallery/texts.h @ONLY CONTENT [[
#pragma once

#include <string_view>

inline constexpr std::string_view kRowTexts = R"rows(@ROW_TEXTS@)rows";
inline constexpr std::string_view kPage = R"page(@PAGE@)page";
]])
