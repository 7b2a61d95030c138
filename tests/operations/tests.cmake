# Reads GCC's dumps of the compiled code: requires GCC.
if(CMAKE_CXX_COMPILER_ID STREQUAL "GNU")
    add_test(NAME operations.ModelAgreesWithTheCode COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/count_operations.py
             ${CMAKE_CXX_COMPILER} ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
    set_tests_properties(operations.ModelAgreesWithTheCode PROPERTIES LABELS slow COST 200 TIMEOUT 36000)
endif()
