find_package(rapidcheck REQUIRED)
set(LINKS test_levels oblong_gallery oblong_platform oblong_tool_cameras rapidcheck)
# Looks at every pixel of thousands of pictures.
set(OPTIMISATION -O1)
