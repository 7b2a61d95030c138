set(LINKS oblong_game)
set(PARTS 3)
