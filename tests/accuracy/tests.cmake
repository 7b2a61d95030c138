# The page on accuracy has the program's measured figures.
add_test(NAME accuracy.ThePageSaysWhatIsMeasured
         COMMAND oblong-accuracy --page ${PROJECT_SOURCE_DIR}/tools/accuracy/README.md --check)
set_tests_properties(accuracy.ThePageSaysWhatIsMeasured PROPERTIES TIMEOUT 36000)

# The program's own report, as a page; a smaller one is in report_test.cpp.
add_test(NAME accuracy.ThePageShowsTheReport
         COMMAND sh -c "command -v node || exit 77; folder=$(mktemp -d) && trap 'rm -r \"$folder\"' EXIT && \"$0\" --quick --out \"$folder\" && node \"$1\" \"$folder\""
                 $<TARGET_FILE:oblong-accuracy> ${CMAKE_CURRENT_LIST_DIR}/page_test.js)
set_tests_properties(accuracy.ThePageShowsTheReport PROPERTIES LABELS slow COST 60 SKIP_RETURN_CODE 77)
