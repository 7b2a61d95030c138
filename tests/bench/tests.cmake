# What measures is run once, on little, to see that it works; its times are not looked at.
if(TARGET oblong-bench)
    add_test(NAME bench.EachBenchmarkRuns COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/each_benchmark_runs.py
             $<TARGET_FILE:oblong-bench>)
endif()
