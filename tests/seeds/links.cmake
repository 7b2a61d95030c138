set(LINKS oblong_methods)
set(CASES_ARE_TESTS ON)  # pages name them
