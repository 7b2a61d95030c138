# The installed files as Debian wants them, before cpack packs them: documents compressed, a game where its games are, and
# all of the release's date.
file(GLOB_RECURSE DOCUMENTS ${CPACK_TEMPORARY_DIRECTORY}/usr/share/man/* ${CPACK_TEMPORARY_DIRECTORY}/usr/share/doc/*/changelog)
execute_process(COMMAND gzip -9nf ${DOCUMENTS} COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${CPACK_TEMPORARY_DIRECTORY}/usr/bin ${CPACK_TEMPORARY_DIRECTORY}/usr/games)
execute_process(COMMAND find ${CPACK_TEMPORARY_DIRECTORY} -exec touch -h -d @${CPACK_OBLONG_DATE_SECONDS} {} + COMMAND_ERROR_IS_FATAL ANY)
