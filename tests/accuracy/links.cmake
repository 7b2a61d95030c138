find_package(nlohmann_json REQUIRED)
set(LINKS oblong_tool_accuracy oblong_tool_article oblong_tool_cameras oblong_tool_map oblong_tool_probe nlohmann_json::nlohmann_json)
set(PARTS 2)
