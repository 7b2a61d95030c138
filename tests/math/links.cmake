find_package(rapidcheck REQUIRED)
set(LINKS oblong_math rapidcheck)
set(APART ALL)
