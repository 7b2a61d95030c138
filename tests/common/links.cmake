find_package(ZLIB REQUIRED)
set(LINKS oblong_tool_cli oblong_tool_formats oblong_tool_log ZLIB::ZLIB)
