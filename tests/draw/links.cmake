set(LINKS oblong_draw)
