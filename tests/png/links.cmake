set(LINKS oblong_tool_png)
