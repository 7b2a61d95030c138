# The fuzz targets of tests/fuzz without the address sanitizer, whose runs take five times as long (tools/fuzz --quick):
# subscripts, front() and back(), sums, products and shifts are checked all the same.
set(CMAKE_CXX_COMPILER clang++ CACHE STRING "")
set(CMAKE_BUILD_TYPE Fuzz CACHE STRING "")
set(CMAKE_CXX_FLAGS_FUZZ "-O2 -gline-tables-only -D_GLIBCXX_ASSERTIONS -fsanitize=fuzzer-no-link,bounds,integer-divide-by-zero,signed-integer-overflow,shift,return,unreachable -fno-sanitize-coverage=trace-cmp -fno-sanitize-recover=all" CACHE STRING "")
set(CMAKE_EXE_LINKER_FLAGS_FUZZ "-fsanitize=undefined" CACHE STRING "")
set(OBLONG_FUZZ ON CACHE BOOL "the fuzz targets" FORCE)
