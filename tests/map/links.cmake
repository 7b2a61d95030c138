set(LINKS oblong_tool_map oblong_platform)
