set(LINKS oblong_frame)
