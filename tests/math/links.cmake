find_package(rapidcheck REQUIRED)
set(LINKS oblong_methods rapidcheck)
