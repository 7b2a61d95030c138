set(LINKS oblong_level oblong_io)
