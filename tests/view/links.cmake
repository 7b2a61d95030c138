find_package(rapidcheck REQUIRED)
set(LINKS oblong_view oblong_methods rapidcheck)
