set(LINKS oblong_game_options)
set(APART tables.cpp)
