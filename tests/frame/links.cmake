set(LINKS oblong_frame)
# Looks at every pixel of thousands of pictures.
set(OPTIMISATION -O2)
