set(LINKS oblong_scene)
