find_package(rapidcheck REQUIRED)
<<<<<<< HEAD
set(LINKS oblong_view rapidcheck)
=======
set(LINKS oblong_view oblong_raster rapidcheck)
set(APART views_test.cpp)
>>>>>>> main
