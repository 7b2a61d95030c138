set(LINKS test_levels oblong_library)
