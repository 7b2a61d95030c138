# Builds the game for a browser and plays it there. A browser is several processes.
add_test(NAME browser.PlaysThePage COMMAND ${CMAKE_CURRENT_LIST_DIR}/play_page ${PROJECT_BINARY_DIR})
set_tests_properties(browser.PlaysThePage PROPERTIES LABELS slow COST 300 TIMEOUT 36000 SKIP_RETURN_CODE 77 PROCESSORS 2)
add_executable(article_figures ${CMAKE_CURRENT_LIST_DIR}/article/figures.cpp)
target_link_libraries(article_figures PRIVATE oblong_tool_article)
add_test(NAME browser.PackSaysWhatIsMissing
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/pack_refusals.py ${PROJECT_SOURCE_DIR})
