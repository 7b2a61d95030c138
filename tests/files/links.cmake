find_package(ZLIB REQUIRED)
set(LINKS oblong_files ZLIB::ZLIB)
set(APART png_test.cpp)
