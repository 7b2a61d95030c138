set(LINKS oblong_geometry oblong_raster)
