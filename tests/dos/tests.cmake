add_long_test_program(walk_hashes ${CMAKE_CURRENT_LIST_DIR}/driver/walk_hashes.cpp)
target_link_libraries(walk_hashes PRIVATE oblong_game_view)
add_long_test_program(walk_sounds ${CMAKE_CURRENT_LIST_DIR}/driver/walk_sounds.cpp)
target_link_libraries(walk_sounds PRIVATE oblong_game_view oblong_game_sound)
add_long_test_program(saved_place ${CMAKE_CURRENT_LIST_DIR}/driver/saved_place.cpp)
target_link_libraries(saved_place PRIVATE oblong_game_saves)
add_long_test_program(arithmetic_hash ${CMAKE_CURRENT_LIST_DIR}/driver/arithmetic.cpp)
target_link_libraries(arithmetic_hash PRIVATE oblong_view)
# Builds the game for DOS (kept in build/dos, so that only the first run is long). Skipped without the cross compiler or
# the emulators.
foreach(WHAT integers qemu memory dosbox saves sound)
    add_test(NAME dos.${WHAT} COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/play_under_dos.py ${WHAT} ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
    set_tests_properties(dos.${WHAT} PROPERTIES LABELS slow COST 200 TIMEOUT 36000 SKIP_RETURN_CODE 77 RESOURCE_LOCK dos_build
                         FIXTURES_REQUIRED "walk_hashes;walk_sounds;saved_place;arithmetic_hash")
endforeach()
# Beside other work QEMU's sound falls behind.
set_tests_properties(dos.sound PROPERTIES RUN_SERIAL ON)
