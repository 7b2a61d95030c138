set(LINKS oblong_methods)
