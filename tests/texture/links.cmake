set(LINKS oblong_tool_texture)
