# Address and undefined-behaviour sanitizers, and subscripts, front() and back() checked; any report ends the program.
set(CMAKE_BUILD_TYPE Asan CACHE STRING "")
set(CMAKE_CXX_FLAGS_ASAN "-O1 -g -D_GLIBCXX_ASSERTIONS -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all" CACHE STRING "")
set(CMAKE_EXE_LINKER_FLAGS_ASAN "-fsanitize=address,undefined" CACHE STRING "")
