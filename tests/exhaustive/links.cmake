# All inputs of the small functions, on two threads: two minutes of the processors' time. `ctest -LE exhaustive` leaves them out.
set(LINKS oblong_math)
set(TEST_PROPERTIES LABELS exhaustive PROCESSORS 2)
set(OPTIMISATION -O2)
