# Only reads the sources: links nothing of the project.
set(LINKS "")
