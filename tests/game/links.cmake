set(LINKS oblong_game)
set(APART four_aspects_test.cpp lab_options_test.cpp movers_test.cpp session_test.cpp view_options_test.cpp)
