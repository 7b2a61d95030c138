set(LINKS oblong_game)
