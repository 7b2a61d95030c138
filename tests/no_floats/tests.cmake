# The option exists in GCC and Clang for x86-64.
if(CMAKE_SYSTEM_PROCESSOR MATCHES "x86_64|AMD64")
    add_test(NAME no_floats.Engine COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/no_floats.py
             ${PROJECT_BINARY_DIR}/compile_commands.json ${PROJECT_SOURCE_DIR})
    add_test(NAME no_floats.PlantedFloats COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/no_floats_test.py ${CMAKE_CXX_COMPILER})
    set_tests_properties(no_floats.Engine PROPERTIES LABELS slow COST 200 TIMEOUT 36000)
endif()
