set(LINKS oblong_frame oblong_platform)
# Looks at every pixel of thousands of pictures.
set(OPTIMISATION -O1)
set(PARTS 6)
