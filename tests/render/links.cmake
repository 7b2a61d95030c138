find_package(nlohmann_json REQUIRED)
set(LINKS test_levels oblong_level oblong_tool_cameras nlohmann_json::nlohmann_json)
