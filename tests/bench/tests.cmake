# What measures is run once, on little, to see that it works; its times are not looked at.
if(TARGET oblong-bench)
    add_test(NAME bench.EachBenchmarkRuns COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/each_benchmark_runs.py
             $<TARGET_FILE:oblong-bench>)
endif()
foreach(SCRIPT stages peer scale compilers)
    add_test(NAME bench.${SCRIPT} COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/scripts_test.py ${PROJECT_SOURCE_DIR}
             ${PROJECT_BINARY_DIR} $<TARGET_FILE:oblong-render> ${SCRIPT})
    set_tests_properties(bench.${SCRIPT} PROPERTIES SKIP_RETURN_CODE 77)
endforeach()
