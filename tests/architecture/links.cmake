# Reads the sources alone: links nothing of the project.
set(LINKS "")
