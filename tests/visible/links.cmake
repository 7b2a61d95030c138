set(LINKS oblong_visible)
