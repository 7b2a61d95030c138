set(LINKS oblong_game oblong_tool_demo_level)
