set(LINKS oblong_platform oblong_io)
# It mostly waits for half a minute: others run meanwhile.
set(TEST_PROPERTIES COST 100)
