# A program of somebody else's, outside the project, takes the library in as engine/library/README.md says. What installs the
# library of this build is quick; the others build the engine again.
foreach(WAY find_package pkg_config add_subdirectory fetch_content shared)
    add_test(NAME consumer.${WAY} COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/consume.py ${WAY} ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
endforeach()
set_tests_properties(consumer.add_subdirectory consumer.fetch_content consumer.shared PROPERTIES
                     LABELS slow COST 200 TIMEOUT 36000)
