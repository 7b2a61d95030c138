set(LINKS oblong_tool_probe oblong_reference)
