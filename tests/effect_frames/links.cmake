find_package(rapidcheck REQUIRED)
set(LINKS oblong_gallery oblong_platform oblong_tool_map oblong_tool_cameras rapidcheck)
# Levels are compiled as in the map compiler's tests.
list(APPEND SOURCES ${CMAKE_CURRENT_SOURCE_DIR}/map/map_source.cpp)
# Looks at every pixel of thousands of pictures.
set(OPTIMISATION -O2)
set(APART mirror_test.cpp models_test.cpp ../map/map_source.cpp)
