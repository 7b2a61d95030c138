# Only an engine that records its ranges has any to print: check_ranges makes a build of its own for it.
add_executable(record_ranges EXCLUDE_FROM_ALL ${CMAKE_CURRENT_LIST_DIR}/recorder/record_ranges.cpp)
target_link_libraries(record_ranges PRIVATE oblong_frame oblong_platform oblong_tool_cameras oblong_tool_cli)

add_test(NAME ranges.EveryQuantityHasHeadRoom COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_ranges ${CMAKE_BINARY_DIR})
set_tests_properties(ranges.EveryQuantityHasHeadRoom PROPERTIES LABELS slow PROCESSORS 2 TIMEOUT 500)
