set(LINKS oblong_frame oblong_tool_cli)
