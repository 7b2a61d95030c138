find_package(ZLIB REQUIRED)
set(LINKS oblong_tool_texture ZLIB::ZLIB)
