set(LINKS oblong_tool_probe oblong_reference)
set(CASES_ARE_TESTS ON)  # pages name them
