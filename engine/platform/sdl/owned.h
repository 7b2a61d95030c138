#pragma once

#include <SDL.h>

#include <memory>

namespace oblong {

struct DestroySdl {
    void operator()(SDL_Window* window) const { SDL_DestroyWindow(window); }
    void operator()(SDL_Renderer* renderer) const { SDL_DestroyRenderer(renderer); }
    void operator()(SDL_Texture* texture) const { SDL_DestroyTexture(texture); }
    void operator()(SDL_Surface* surface) const { SDL_FreeSurface(surface); }
    void operator()(SDL_GameController* controller) const { SDL_GameControllerClose(controller); }
};

/// Something of SDL that is destroyed with its owner.
template <class T>
using Owned = std::unique_ptr<T, DestroySdl>;

}  // namespace oblong
