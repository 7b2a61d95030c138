set(LINKS oblong_view oblong_methods)
