set(LINKS oblong_tool_map oblong_models oblong_game)
