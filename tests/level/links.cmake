set(LINKS oblong_level)
set(APART ALL)
