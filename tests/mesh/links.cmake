set(LINKS oblong_gallery)
# Looks at every pixel of pictures.
set(OPTIMISATION -O2)
set(APART draw_mesh_test.cpp mesh_stages_test.cpp)
