set(LINKS oblong_pictures)
