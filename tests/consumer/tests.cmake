# A program outside the project uses the library as described in engine/library/README.md. The test that installs this
# build's library is quick; the next compiles each header with each compiler, and the others build the engine again.
foreach(WAY find_package pkg_config add_subdirectory fetch_content shared libcxx)
    add_test(NAME consumer.${WAY} COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/consume.py ${WAY} ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
endforeach()
set_tests_properties(consumer.add_subdirectory consumer.fetch_content consumer.shared consumer.libcxx PROPERTIES
                     LABELS slow COST 200 TIMEOUT 36000 SKIP_RETURN_CODE 77)
set_tests_properties(consumer.pkg_config PROPERTIES LABELS slow)
add_test(NAME consumer.for_windows COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/compile_for_windows.py ${PROJECT_SOURCE_DIR})
set_tests_properties(consumer.for_windows PROPERTIES LABELS slow COST 30 SKIP_RETURN_CODE 77)
