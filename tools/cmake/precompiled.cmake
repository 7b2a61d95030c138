# The standard library's headers take half of the time that an ordinary file takes to compile, so they are precompiled -
# unless a compiler cache remembers whole files, which it can't do then. A file still includes what it uses: builds with a
# cache, and those of tests/determinism, have nothing precompiled.
if(NOT CMAKE_CXX_COMPILER_LAUNCHER)
    file(CONFIGURE OUTPUT standard_headers.cpp CONTENT "")
    add_library(standard_headers OBJECT ${CMAKE_CURRENT_BINARY_DIR}/standard_headers.cpp)
    target_precompile_headers(standard_headers PRIVATE <algorithm> <array> <bit> <cmath> <cstdint> <functional> <limits>
                              <map> <memory> <optional> <span> <string> <string_view> <vector>)
endif()

# reuse_precompiled_headers(FOLDER): in every library and program of FOLDER and below.
function(reuse_precompiled_headers FOLDER)
    get_property(TARGETS DIRECTORY ${FOLDER} PROPERTY BUILDSYSTEM_TARGETS)
    foreach(NAME ${TARGETS})
        get_target_property(KIND ${NAME} TYPE)
        if(TARGET standard_headers AND KIND MATCHES "STATIC_LIBRARY|EXECUTABLE")
            target_precompile_headers(${NAME} REUSE_FROM standard_headers)
        endif()
    endforeach()
    get_property(FOLDERS DIRECTORY ${FOLDER} PROPERTY SUBDIRECTORIES)
    foreach(BELOW ${FOLDERS})
        reuse_precompiled_headers(${BELOW})
    endforeach()
endfunction()
