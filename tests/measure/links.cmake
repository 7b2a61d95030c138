set(LINKS oblong_tool_measure)
