# Adapts the installed files to Debian before cpack packs them: compressed documents, the game in /usr/games, and all with
# the release's date.
set(GAME ${CPACK_TEMPORARY_DIRECTORY}/game/usr)
set(DEVELOPMENT ${CPACK_TEMPORARY_DIRECTORY}/development/usr)
file(GLOB_RECURSE DOCUMENTS ${GAME}/share/man/* ${GAME}/share/doc/*/changelog)
execute_process(COMMAND gzip -9nf ${DOCUMENTS} COMMAND_ERROR_IS_FATAL ANY)
file(RENAME ${GAME}/bin ${GAME}/games)
if(EXISTS ${DEVELOPMENT})
    file(COPY ${GAME}/share/doc/oblong/ DESTINATION ${DEVELOPMENT}/share/doc/liboblong-dev)
    # In the folder in which pkg-configs for other architectures also look.
    set(OF_ARCHITECTURE ${DEVELOPMENT}/lib/${CPACK_OBLONG_ARCHITECTURE})
    file(MAKE_DIRECTORY ${OF_ARCHITECTURE})
    file(RENAME ${DEVELOPMENT}/lib/pkgconfig ${OF_ARCHITECTURE}/pkgconfig)
    execute_process(COMMAND sed -i s,^prefix=.*,&/.., ${OF_ARCHITECTURE}/pkgconfig/oblong.pc COMMAND_ERROR_IS_FATAL ANY)
endif()
execute_process(COMMAND find ${CPACK_TEMPORARY_DIRECTORY} -exec touch -h -d @${CPACK_OBLONG_DATE_SECONDS} {} + COMMAND_ERROR_IS_FATAL ANY)
