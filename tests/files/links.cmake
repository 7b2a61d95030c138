find_package(ZLIB REQUIRED)
set(LINKS oblong_pictures oblong_programs oblong_sound ZLIB::ZLIB)
