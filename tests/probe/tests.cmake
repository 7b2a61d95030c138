# Thousands of queries against exact rationals.
add_test(NAME probe.exact_references
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/check.py $<TARGET_FILE:oblong-probe> --scale 0.5)
set_tests_properties(probe.exact_references PROPERTIES TIMEOUT 36000 COST 100)
