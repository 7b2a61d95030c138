set(LINKS oblong_tool_demo_level oblong_game)
