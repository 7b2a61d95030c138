find_package(ZLIB REQUIRED)
set(LINKS oblong_files ZLIB::ZLIB)
