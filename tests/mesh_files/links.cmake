set(LINKS oblong_mesh)
