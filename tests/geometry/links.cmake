find_package(rapidcheck REQUIRED)
set(LINKS oblong_geometry oblong_raster rapidcheck)
