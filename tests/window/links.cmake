set(LINKS oblong_platform oblong_files)
# Most of its half minute is waiting: others run meanwhile.
set(TEST_PROPERTIES COST 100)
