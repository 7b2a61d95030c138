set(LINKS oblong_level)
