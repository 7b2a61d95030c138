# All inputs of small functions: two minutes of processor time. `ctest -LE exhaustive` leaves them out.
set(LINKS oblong_methods)
set(PARTS 8)
set(TEST_PROPERTIES LABELS exhaustive COST 50)
set(OPTIMISATION -O1)
