set(LINKS oblong_level oblong_files)
set(APART render_test.cpp)
