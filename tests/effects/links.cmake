set(LINKS oblong_effects)
set(APART ALL)
