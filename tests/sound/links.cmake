set(LINKS oblong_game)
set(APART waves_test.cpp)
