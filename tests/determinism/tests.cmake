# Builds the renderer once more for each configuration (kept in build/determinism, so that only the first run is long).
add_test(NAME determinism.EveryBuildDrawsTheSamePictures
         COMMAND ${CMAKE_CURRENT_LIST_DIR}/compare_builds ${CMAKE_BINARY_DIR})
set_tests_properties(determinism.EveryBuildDrawsTheSamePictures PROPERTIES
                     LABELS slow PROCESSORS 2 TIMEOUT 1500 SKIP_RETURN_CODE 77)
