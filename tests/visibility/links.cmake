set(LINKS oblong_visibility)
set(APART ALL)
