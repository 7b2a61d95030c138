find_package(nlohmann_json REQUIRED)
set(LINKS oblong_level nlohmann_json::nlohmann_json)
