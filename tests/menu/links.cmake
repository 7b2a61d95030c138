set(LINKS oblong_game)
set(APART menu_layout_test.cpp pages_test.cpp)
