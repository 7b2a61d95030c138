# All that RapidCheck feeds, as its headers take longest to compile.
find_package(rapidcheck REQUIRED)
set(LINKS test_levels oblong_methods oblong_gallery rapidcheck)
# Looks at every pixel of thousands of pictures.
set(OPTIMISATION -O1)
