find_package(nlohmann_json REQUIRED)
set(LINKS test_levels oblong_platform oblong_tool_render oblong_game nlohmann_json::nlohmann_json)
set(PARTS 3)
