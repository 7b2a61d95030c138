# Each file in targets/ with the inputs of its corpus and INPUTS more, in less than a minute: the same ones each time.
# tools/fuzz builds it separately (in build/fuzz, by tools/presets/fuzz.cmake).
set(FEWER_INPUTS levels 1500 entities 1500 maps 400 saves 1500 demos 1500 mdl 3000 obj 3000 options 2000 command_line 500
                 library 2000)
file(GLOB FUZZ_TARGETS CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/targets/*.cpp)
foreach(SOURCE ${FUZZ_TARGETS})
    get_filename_component(NAME ${SOURCE} NAME_WE)
    set(INPUTS 10000)
    list(FIND FEWER_INPUTS ${NAME} AT)
    if(NOT AT EQUAL -1)
        math(EXPR AT "${AT} + 1")
        list(GET FEWER_INPUTS ${AT} INPUTS)
    endif()
    add_test(NAME fuzz.${NAME} COMMAND ${PROJECT_SOURCE_DIR}/tools/fuzz ${NAME} --inputs ${INPUTS})
    set_tests_properties(fuzz.${NAME} PROPERTIES LABELS slow COST 100 TIMEOUT 36000)
endforeach()
if(NOT OBLONG_FUZZ)
    return()
endif()

# A program for each, with Clang's libFuzzer. It includes the parts of the game that read files and play.
find_package(ZLIB REQUIRED)
file(GLOB SOURCES CONFIGURE_DEPENDS ${CMAKE_CURRENT_LIST_DIR}/common/*.cpp)
add_library(fuzzed STATIC ${SOURCES})
target_link_libraries(fuzzed PUBLIC oblong_frame oblong_platform_sdl oblong_game_saves oblong_game_options oblong_game_sound oblong_library
                                    test_levels oblong_tool_probe oblong_tool_cameras test_support GTest::gtest ZLIB::ZLIB)
foreach(SOURCE ${FUZZ_TARGETS})
    get_filename_component(NAME ${SOURCE} NAME_WE)
    add_executable(fuzz_${NAME} ${SOURCE})
    target_link_libraries(fuzz_${NAME} PRIVATE fuzzed)
    target_link_options(fuzz_${NAME} PRIVATE -fsanitize=fuzzer)
endforeach()

# These compare numbers all the time: tracing that takes half of a run and finds no inputs. CLI11 is slow without it.
foreach(ROOM surface effects)
    target_compile_options(oblong_${ROOM} PRIVATE -fno-sanitize-coverage=trace-cmp)
endforeach()
set_source_files_properties(${PROJECT_SOURCE_DIR}/engine/programs/command_line.cpp TARGET_DIRECTORY oblong_programs
                            PROPERTIES COMPILE_OPTIONS "-O1;-fno-sanitize-coverage=trace-cmp")
