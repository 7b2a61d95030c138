set(LINKS oblong_platform)
