set(LINKS oblong_visibility)
set(PARTS 2)
