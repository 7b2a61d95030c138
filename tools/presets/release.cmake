# The scripts' default: what is measured and played. Portable x86-64 baseline. No debug information, which takes a quarter
# of the time that building takes; the preset `debug` has it.
set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
