set(LINKS oblong_fixed)
