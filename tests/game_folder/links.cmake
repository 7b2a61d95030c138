find_package(nlohmann_json REQUIRED)
set(LINKS oblong_game nlohmann_json::nlohmann_json)
