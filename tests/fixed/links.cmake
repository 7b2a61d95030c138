find_package(rapidcheck REQUIRED)
set(LINKS oblong_fixed rapidcheck)
set(APART ALL)
