# Builds the renderer once more for each configuration (kept in build/determinism, so that only the first run is long).
add_test(NAME determinism.EveryBuildDrawsTheSamePictures
         COMMAND ${CMAKE_CURRENT_LIST_DIR}/compare_builds ${CMAKE_BINARY_DIR})
set_tests_properties(determinism.EveryBuildDrawsTheSamePictures PROPERTIES
                     LABELS slow COST 300 TIMEOUT 1500 SKIP_RETURN_CODE 77)

# Skipped where a cross compiler and an emulator are not installed: they are big, and tools/test does not ask for them.
add_test(NAME determinism.AnotherMachineDrawsTheSamePictures
         COMMAND ${CMAKE_CURRENT_LIST_DIR}/compare_machines ${CMAKE_BINARY_DIR})
set_tests_properties(determinism.AnotherMachineDrawsTheSamePictures PROPERTIES
                     LABELS slow COST 200 TIMEOUT 500 SKIP_RETURN_CODE 77)
