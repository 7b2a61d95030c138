# Makes a separate build, whose engine records its ranges.
add_test(NAME ranges.EveryQuantityHasHeadRoom COMMAND ${CMAKE_CURRENT_LIST_DIR}/check_ranges ${PROJECT_BINARY_DIR})
set_tests_properties(ranges.EveryQuantityHasHeadRoom PROPERTIES LABELS slow COST 200 TIMEOUT 36000)
