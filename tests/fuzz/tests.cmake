# A minute of each file in targets/, which tools/fuzz builds for itself (in build/fuzz, by tools/presets/fuzz.cmake).
file(GLOB FUZZ_TARGETS CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/targets/*.cpp)
foreach(SOURCE ${FUZZ_TARGETS})
    get_filename_component(NAME ${SOURCE} NAME_WE)
    add_test(NAME fuzz.${NAME} COMMAND ${CMAKE_SOURCE_DIR}/tools/fuzz ${NAME} 60)
    set_tests_properties(fuzz.${NAME} PROPERTIES LABELS slow COST 100 TIMEOUT 36000)
endforeach()
if(NOT OBLONG_FUZZ)
    return()
endif()

# A program for each, by Clang's libFuzzer. Of the game they take what reads files and plays.
find_package(ZLIB REQUIRED)
set(GAME ${CMAKE_SOURCE_DIR}/game)
file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/common/*.cpp ${GAME}/simulation/*.cpp)
list(APPEND SOURCES ${CMAKE_CURRENT_LIST_DIR}/../map/map_source.cpp ${GAME}/route.cpp ${GAME}/saves/saved_game.cpp
     ${GAME}/saves/state_bytes.cpp ${GAME}/preferences/options_text.cpp ${GAME}/preferences/preference_kinds.cpp
     ${GAME}/preferences/preference_table.cpp ${GAME}/preferences/view_preferences.cpp)
add_library(fuzzed STATIC ${SOURCES})
target_link_libraries(fuzzed PUBLIC oblong_frame oblong_platform oblong_tool_map oblong_files
                                    oblong_tool_probe oblong_tool_cameras
                                    test_support GTest::gtest ZLIB::ZLIB)
foreach(SOURCE ${FUZZ_TARGETS})
    get_filename_component(NAME ${SOURCE} NAME_WE)
    add_executable(fuzz_${NAME} ${SOURCE})
    target_link_libraries(fuzz_${NAME} PRIVATE fuzzed)
    target_link_options(fuzz_${NAME} PRIVATE -fsanitize=fuzzer)
endforeach()

# Comparing numbers is what these do all the time: traced, it takes half of a run and leads nowhere. CLI11 is slow enough.
foreach(ROOM surface effects)
    target_compile_options(oblong_${ROOM} PRIVATE -fno-sanitize-coverage=trace-cmp)
endforeach()
set_source_files_properties(${CMAKE_SOURCE_DIR}/engine/files/config_line.cpp TARGET_DIRECTORY oblong_files
                            PROPERTIES COMPILE_OPTIONS "-O1;-fno-sanitize-coverage=trace-cmp")
