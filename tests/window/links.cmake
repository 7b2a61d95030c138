set(LINKS "")
