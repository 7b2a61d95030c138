# Read by cpack before it makes a package: the same files make the same bytes, and the package's dependencies are required.
set(ENV{SOURCE_DATE_EPOCH} ${CPACK_OBLONG_DATE_SECONDS})
find_program(SHLIBDEPS dpkg-shlibdeps)
if(NOT SHLIBDEPS)
    message(FATAL_ERROR "dpkg-shlibdeps: not there, expected it to find the package's dependencies (Debian: dpkg-dev)")
endif()
