set(LINKS oblong_geometry)
