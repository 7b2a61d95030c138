find_package(rapidcheck REQUIRED)
set(LINKS oblong_view rapidcheck)
set(APART views_test.cpp)
