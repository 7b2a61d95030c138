# As engine/rooms.cmake.
set(OBLONG_PART game_lower)
oblong_room(game_simulation simulation DEPENDS scene)
oblong_room(game_input      input      DEPENDS game_simulation platform)
oblong_room(game_options    options    DEPENDS game_input programs costs)
oblong_room(game_level      level      DEPENDS game_simulation models sound programs)
oblong_room(game_saves      saves      DEPENDS game_level)
oblong_room(game_sound      sound      DEPENDS game_simulation sound programs)
set(OBLONG_PART game_upper)
oblong_room(game_menu       menu       DEPENDS game_options)
oblong_room(game_view       view       DEPENDS game_options game_level pictures)
oblong_room(game_lab        lab        DEPENDS game_view measure DESKTOP reference_meter.cpp)
# Without its main, so that tests can play it.
oblong_room(game            program    DEPENDS game_saves game_sound game_menu game_lab platform_sdl EXCEPT main.cpp)
