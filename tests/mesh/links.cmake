set(LINKS oblong_gallery)
# Looks at every pixel of pictures.
set(OPTIMISATION -O1)
