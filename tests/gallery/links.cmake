set(LINKS oblong_gallery_program)
