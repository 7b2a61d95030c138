# Release, optimised by the counts of an earlier instrumented build (tools/build): GCC only. Functions that did not run
# then are optimised as in a release.
set(CMAKE_BUILD_TYPE Profiled CACHE STRING "")
set(CMAKE_CXX_FLAGS_PROFILED "-O2 -DNDEBUG -fprofile-use -fprofile-partial-training -Wno-missing-profile -Wno-stringop-overread" CACHE STRING "")
