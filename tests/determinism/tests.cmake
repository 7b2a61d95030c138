# Builds the renderer for each configuration (kept in build/determinism, so that only the first run is long).
add_test(NAME determinism.EveryBuildDrawsTheSamePictures
         COMMAND ${CMAKE_CURRENT_LIST_DIR}/compare_builds ${PROJECT_BINARY_DIR})
set_tests_properties(determinism.EveryBuildDrawsTheSamePictures PROPERTIES
                     LABELS slow COST 300 TIMEOUT 36000 SKIP_RETURN_CODE 77)

# Ten thousand ticks are five minutes of play, 3,024,000 a day.
add_executable(long_play ${CMAKE_CURRENT_LIST_DIR}/driver/long_play.cpp)
target_compile_options(long_play PRIVATE -O2)
target_link_libraries(long_play PRIVATE oblong_game)
add_test(NAME determinism.AnHourOfPlay COMMAND ${CMAKE_CURRENT_LIST_DIR}/play_for_long ${PROJECT_BINARY_DIR} 126000)
add_test(NAME determinism.ADayOfPlay COMMAND ${CMAKE_CURRENT_LIST_DIR}/play_for_long ${PROJECT_BINARY_DIR} 3024000)
set_tests_properties(determinism.AnHourOfPlay PROPERTIES TIMEOUT 36000)
set_tests_properties(determinism.ADayOfPlay PROPERTIES LABELS slow COST 300 TIMEOUT 36000)

# Skipped without a cross compiler and an emulator: tools/test --all installs those of only two machines.
foreach(MACHINE s390x ppc arm i686 aarch64 wasm)
    add_test(NAME determinism.TheSameOn_${MACHINE} COMMAND ${CMAKE_CURRENT_LIST_DIR}/compare_machines ${PROJECT_BINARY_DIR} ${MACHINE})
    set_tests_properties(determinism.TheSameOn_${MACHINE} PROPERTIES
                         LABELS slow COST 200 TIMEOUT 36000 SKIP_RETURN_CODE 77)
endforeach()
