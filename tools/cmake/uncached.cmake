# A fast build without a compiler cache: several rooms (OBLONG_PART of rooms.cmake) are compiled as one file, and the
# standard library's headers are precompiled, which together save three quarters of the time. A cache works only with
# whole files, and better with small ones, so with a cache each file is compiled separately. Each file therefore includes
# what it uses, and its own names (in an anonymous namespace) are unique in its part. -D CMAKE_UNITY_BUILD=OFF suits
# frequent changes without a cache.
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
    if(NOT DEFINED CMAKE_UNITY_BUILD)
        set(CMAKE_UNITY_BUILD ON)
    endif()
    if(NOT DEFINED CMAKE_UNITY_BUILD_BATCH_SIZE)
        set(CMAKE_UNITY_BUILD_BATCH_SIZE 0)
    endif()
endif()
# GCC does not collect garbage below 1 GB (it rarely needs more): a tenth of the time.
if(NOT CMAKE_CXX_COMPILER_LAUNCHER AND CMAKE_CXX_COMPILER_ID STREQUAL GNU)
    add_compile_options("SHELL:--param ggc-min-heapsize=1000000")
endif()
# Programs and libraries share one set, if they are compiled alike.
if(NOT CMAKE_CXX_COMPILER_LAUNCHER AND NOT CMAKE_POSITION_INDEPENDENT_CODE)
    file(CONFIGURE OUTPUT standard_headers.cpp CONTENT "")
    add_library(oblong_standard_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/standard_headers.cpp)
    set_target_properties(oblong_standard_headers PROPERTIES UNITY_BUILD OFF)
    target_precompile_headers(oblong_standard_headers PRIVATE <algorithm> <array> <bit> <cmath> <cstdint> <functional>
                              <limits> <map> <memory> <optional> <span> <string> <string_view> <vector>)
endif()

# optimise_less(TARGETS): for code that runs once, or a few times a frame. Saves a third of its compile time.
function(optimise_less)
    set(COMPILED "")
    foreach(NAME ${ARGN})
        get_target_property(KIND ${NAME} TYPE)
        if(KIND STREQUAL INTERFACE_LIBRARY)  # a room in a part
            get_target_property(NAME ${NAME} INTERFACE_LINK_LIBRARIES)
        endif()
        list(APPEND COMPILED ${NAME})
    endforeach()
    list(REMOVE_DUPLICATES COMPILED)
    foreach(NAME ${COMPILED})
        if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
            target_compile_options(${NAME} PRIVATE $<$<CONFIG:Release>:-Og>)
        endif()
    endforeach()
endfunction()

# reuse_precompiled_headers(FOLDER): in every library and program of FOLDER and below.
function(reuse_precompiled_headers FOLDER)
    get_property(TARGETS DIRECTORY ${FOLDER} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(NAME ${TARGETS})
        get_target_property(KIND ${NAME} TYPE)
        if(TARGET oblong_standard_headers AND KIND MATCHES "STATIC_LIBRARY|EXECUTABLE")
            target_precompile_headers(${NAME} REUSE_FROM oblong_standard_headers)
        endif()
    endforeach()
    get_property(FOLDERS DIRECTORY ${FOLDER} PROPERTY SUBDIRECTORIES)
    foreach(BELOW ${FOLDERS})
        reuse_precompiled_headers(${BELOW})
    endforeach()
endfunction()
