set(LINKS test_levels oblong_gallery oblong_platform oblong_tool_cameras)
# Looks at every pixel of thousands of pictures.
set(OPTIMISATION -O1)
set(PARTS 3)
