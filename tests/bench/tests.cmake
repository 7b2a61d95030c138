# Runs the measuring programs once, on little, to see that they work; ignores their times.
if(TARGET oblong-bench)
    add_test(NAME bench.EachBenchmarkRuns COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/each_benchmark_runs.py
             $<TARGET_FILE:oblong-bench>)
endif()
foreach(SCRIPT stages peer compilers light)
    add_test(NAME bench.${SCRIPT} COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/scripts_test.py ${PROJECT_SOURCE_DIR}
             ${PROJECT_BINARY_DIR} $<TARGET_FILE:oblong-render> ${SCRIPT})
    set_tests_properties(bench.${SCRIPT} PROPERTIES SKIP_RETURN_CODE 77)
endforeach()
set_tests_properties(bench.stages bench.light PROPERTIES LABELS slow)
add_long_test_program(draw_unseen ${CMAKE_CURRENT_LIST_DIR}/unseen/draw_unseen.cpp)
target_link_libraries(draw_unseen PRIVATE oblong_tool_cameras oblong_models oblong_programs)
foreach(LEVELS demo real)
    add_test(NAME bench.UnseenCostsLittle_${LEVELS} COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/unseen_costs.py
             ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR} $<TARGET_FILE:draw_unseen> ${LEVELS})
    set_tests_properties(bench.UnseenCostsLittle_${LEVELS} PROPERTIES SKIP_RETURN_CODE 77 LABELS slow COST 100 TIMEOUT 36000
                         FIXTURES_REQUIRED draw_unseen)
endforeach()
