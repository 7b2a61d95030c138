# The page on accuracy has the program's measured figures.
add_test(NAME accuracy.ThePageSaysWhatIsMeasured
         COMMAND oblong-accuracy --page ${PROJECT_SOURCE_DIR}/tools/accuracy/README.md --check)
set_tests_properties(accuracy.ThePageSaysWhatIsMeasured PROPERTIES TIMEOUT 36000)

# The contents of the report's page, by its own script.
add_test(NAME accuracy.ThePageShowsTheReport
         COMMAND sh -c "command -v node || exit 77; exec node \"$@\"" sh ${CMAKE_CURRENT_LIST_DIR}/page_test.js
                 $<TARGET_FILE:oblong-accuracy>)
set_tests_properties(accuracy.ThePageShowsTheReport PROPERTIES SKIP_RETURN_CODE 77)
