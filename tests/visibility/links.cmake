set(LINKS oblong_visibility)
