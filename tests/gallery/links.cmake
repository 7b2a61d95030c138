set(LINKS oblong_gallery)
