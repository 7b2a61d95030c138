set(LINKS oblong_game_options)
