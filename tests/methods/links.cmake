find_package(rapidcheck REQUIRED)
set(LINKS oblong_methods oblong_platform oblong_tool_map oblong_tool_cameras rapidcheck)
# Levels are compiled as in the map compiler's tests, and drawn as in the effects' tests.
list(APPEND SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/map/map_source.cpp ${CMAKE_CURRENT_SOURCE_DIR}/effect_frames/effect_stage.cpp)
# Looks at every pixel of thousands of pictures.
set(OPTIMISATION -O2)
set(APART ALL)
