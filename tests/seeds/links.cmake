set(LINKS oblong_math)
