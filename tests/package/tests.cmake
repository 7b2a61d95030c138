# Installs the build into its own folder and checks the files.
add_test(NAME package.WhatIsInstalledRuns
         COMMAND python3 ${CMAKE_CURRENT_LIST_DIR}/check_installed.py ${PROJECT_BINARY_DIR} ${PROJECT_VERSION})
add_test(NAME package.LicencesSuitAndAreNamed
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/check_licences.py ${PROJECT_BINARY_DIR} ${PROJECT_SOURCE_DIR})
add_test(NAME package.TwoBuildsAtOnceWait COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/two_builds.py ${PROJECT_SOURCE_DIR})
