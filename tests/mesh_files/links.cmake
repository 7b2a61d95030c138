set(LINKS oblong_files)
