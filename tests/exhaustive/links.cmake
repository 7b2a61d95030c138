# All inputs of the small functions, in two minutes of the processors' time. `ctest -LE exhaustive` leaves them out.
set(LINKS oblong_methods)
set(TEST_PROPERTIES LABELS exhaustive COST 50)
set(OPTIMISATION -O2)
