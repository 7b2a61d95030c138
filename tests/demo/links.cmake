set(LINKS oblong_tool_map oblong_tool_models oblong_game)
