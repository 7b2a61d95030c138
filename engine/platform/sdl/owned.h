#pragma once

#include <memory>

struct SDL_Window;
struct SDL_Renderer;
struct SDL_Texture;
struct SDL_Surface;

namespace oblong {

struct DestroySdl {
    void operator()(SDL_Window* window) const;
    void operator()(SDL_Renderer* renderer) const;
    void operator()(SDL_Texture* texture) const;
    void operator()(SDL_Surface* surface) const;
};

/// A window, renderer, texture or surface of SDL that is destroyed with its owner.
template <class T>
using Owned = std::unique_ptr<T, DestroySdl>;

}  // namespace oblong
