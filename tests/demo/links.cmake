set(LINKS oblong_tool_map oblong_files oblong_game)
