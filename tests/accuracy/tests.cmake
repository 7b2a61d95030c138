# The figures of the page on accuracy are those that the program measures.
add_test(NAME accuracy.ThePageSaysWhatIsMeasured
         COMMAND oblong-accuracy --page ${PROJECT_SOURCE_DIR}/tools/accuracy/README.md --check)
set_tests_properties(accuracy.ThePageSaysWhatIsMeasured PROPERTIES TIMEOUT 36000)

# What the report's page shows, by its own script.
add_test(NAME accuracy.ThePageShowsTheReport
         COMMAND sh -c "command -v node || exit 77; exec node \"$@\"" sh ${CMAKE_CURRENT_LIST_DIR}/page_test.js
                 $<TARGET_FILE:oblong-accuracy>)
set_tests_properties(accuracy.ThePageShowsTheReport PROPERTIES SKIP_RETURN_CODE 77)
