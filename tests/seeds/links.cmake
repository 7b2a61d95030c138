set(LINKS oblong_view oblong_raster)
