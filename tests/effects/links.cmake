set(LINKS oblong_effects)
