#pragma once

#include <memory>

struct SDL_Window;
struct SDL_Renderer;
struct SDL_Texture;

namespace oblong {

struct DestroySdl {
    void operator()(SDL_Window* window) const;
    void operator()(SDL_Renderer* renderer) const;
    void operator()(SDL_Texture* texture) const;
};

/// A window, renderer or texture of SDL that is destroyed with its owner.
template <class T>
using Owned = std::unique_ptr<T, DestroySdl>;

}  // namespace oblong
