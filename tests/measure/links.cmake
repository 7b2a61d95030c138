set(LINKS oblong_measure)
