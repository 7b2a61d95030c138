set(LINKS oblong_files)
set(APART obj_test.cpp)
