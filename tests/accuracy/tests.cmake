# The first page's figures are those that the program measures.
add_test(NAME accuracy.TheFirstPageSaysWhatIsMeasured
         COMMAND oblong-accuracy --page ${CMAKE_SOURCE_DIR}/README.md --check)
set_tests_properties(accuracy.TheFirstPageSaysWhatIsMeasured PROPERTIES TIMEOUT 300)
