# Makes a build of its own: only an engine that records its ranges has any to print.
add_test(NAME ranges.EveryQuantityHasHeadRoom COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_ranges ${PROJECT_BINARY_DIR})
set_tests_properties(ranges.EveryQuantityHasHeadRoom PROPERTIES LABELS slow COST 200 TIMEOUT 36000)
