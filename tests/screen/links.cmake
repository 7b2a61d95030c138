set(LINKS oblong_screen)
