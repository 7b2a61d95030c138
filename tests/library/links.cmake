set(LINKS oblong_library oblong_tool_map)
# Levels are compiled as in the map compiler's tests.
list(APPEND SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/map/map_source.cpp)
set(APART ../map/map_source.cpp)
