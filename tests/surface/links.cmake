set(LINKS oblong_raster)
