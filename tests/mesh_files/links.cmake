set(LINKS oblong_tool_models)
