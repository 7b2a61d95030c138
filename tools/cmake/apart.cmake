# Shared by separate projects that compile the same sources for another machine: include() it after project(). ROOT is
# this project's folder.
set(CMAKE_CXX_STANDARD 20)
set(CMAKE_CXX_STANDARD_REQUIRED ON)
set(CMAKE_CXX_EXTENSIONS OFF)
if(NOT CMAKE_BUILD_TYPE)
    set(CMAKE_BUILD_TYPE Release)
endif()
cmake_path(SET ROOT NORMALIZE ${CMAKE_CURRENT_LIST_DIR}/../..)
cmake_path(GET ROOT PARENT_PATH ROOT)  # without a slash at its end
include_directories(${ROOT})
# The whole project's version.
file(READ ${ROOT}/CMakeLists.txt PROJECT_LISTS)
string(REGEX MATCH "VERSION ([0-9]+\\.[0-9]+\\.[0-9]+) LANGUAGES" IGNORED "${PROJECT_LISTS}")
add_compile_definitions(OBLONG_VERSION="${CMAKE_MATCH_1}")
