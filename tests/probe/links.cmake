set(LINKS oblong_tool_probe)
