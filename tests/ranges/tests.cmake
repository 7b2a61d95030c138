# The engine once more, recording its ranges: built when its test runs.
file(GLOB_RECURSE RECORDED CONFIGURE_DEPENDS ${CMAKE_SOURCE_DIR}/engine/*.cpp)
list(FILTER RECORDED EXCLUDE REGEX "/engine/platform/")
add_executable(record_ranges EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/recorder/record_ranges.cpp ${RECORDED}
               ${CMAKE_SOURCE_DIR}/engine/platform/files.cpp
               ${CMAKE_SOURCE_DIR}/tools/cli/program.cpp
               ${CMAKE_SOURCE_DIR}/tools/cli/arguments.cpp ${CMAKE_SOURCE_DIR}/tools/render/camera_list.cpp)
target_compile_definitions(record_ranges PRIVATE OBLONG_RECORD_RANGES)

add_test(NAME ranges.EveryQuantityHasHeadRoom COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_ranges ${CMAKE_BINARY_DIR})
set_tests_properties(ranges.EveryQuantityHasHeadRoom PROPERTIES LABELS slow PROCESSORS 2 TIMEOUT 500)
