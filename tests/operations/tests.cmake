add_test(NAME operations.PricesAgreeWithCountedInstructions
         COMMAND python3 -B ${CMAKE_CURRENT_LIST_DIR}/costs.py check ${PROJECT_SOURCE_DIR} ${PROJECT_BINARY_DIR})
set_tests_properties(operations.PricesAgreeWithCountedInstructions PROPERTIES LABELS slow COST 200 TIMEOUT 36000
                     SKIP_RETURN_CODE 77)
