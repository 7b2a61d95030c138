set(LINKS test_levels oblong_platform oblong_tool_render oblong_game)
set(APART bit_set_test.cpp bsp_checks.cpp compile_test.cpp level_checks_test.cpp parts_test.cpp surfaces_test.cpp)
