set(LINKS oblong_surface)
