set(LINKS oblong_tool_reference oblong_tool_cameras oblong_frame)
set(APART ALL)
