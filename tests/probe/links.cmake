set(LINKS oblong_tool_probe oblong_tool_reference)
# Thousands of queries against exact rationals.
find_package(Python3 REQUIRED COMPONENTS Interpreter)
add_test(NAME probe.exact_references
         COMMAND Python3::Interpreter -B ${CMAKE_CURRENT_SOURCE_DIR}/probe/check.py $<TARGET_FILE:oblong-probe> 1 0.5)
set_tests_properties(probe.exact_references PROPERTIES TIMEOUT 600)
