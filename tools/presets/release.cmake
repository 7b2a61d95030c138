# The scripts' default, for measuring and playing. Portable x86-64 baseline. Without debug information, which takes a
# quarter of the build time; the preset `debug` has it.
set(CMAKE_BUILD_TYPE Release CACHE STRING "")
set(CMAKE_CXX_FLAGS_RELEASE "-O2 -DNDEBUG" CACHE STRING "")
# gold, a part of Debian's binutils, links in half the time of the usual linker.
find_program(OBLONG_GOLD ld.gold)
if(OBLONG_GOLD)
    set(CMAKE_EXE_LINKER_FLAGS "-fuse-ld=gold" CACHE STRING "")
endif()
