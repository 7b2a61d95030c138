find_package(rapidcheck REQUIRED)
set(LINKS oblong_raster rapidcheck)
