#include "engine/platform/sdl/message_box.h"

#include <SDL.h>

namespace oblong {

void show_error_box(const std::string& title, const std::string& text) {
    SDL_ShowSimpleMessageBox(SDL_MESSAGEBOX_ERROR, title.c_str(), text.c_str(), nullptr);
}

}  // namespace oblong
