set(LINKS oblong_tool_map)
