find_package(rapidcheck REQUIRED)
set(LINKS oblong_view oblong_raster rapidcheck)
set(APART views_test.cpp)
