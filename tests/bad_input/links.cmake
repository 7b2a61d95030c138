set(LINKS oblong_level oblong_tool_formats)
