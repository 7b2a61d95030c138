set(LINKS oblong_tool_map oblong_platform oblong_tool_render oblong_game)
set(APART ALL)
