#pragma once

#include "engine/platform/sdl/owned.h"
#include "engine/view/present_rect.h"

namespace oblong {

/// Draws the CRT look over the picture in a window. Its textures are made at the first picture.
class CrtLook {
  public:
    /// The renderer outlives it.
    explicit CrtLook(SDL_Renderer* renderer) : renderer_(renderer) {}

    /// Draws over a picture that is shown in `shown`: scanlines and a mask, then the glow around bright parts. Leaves
    /// out effects that the renderer does not support.
    void draw_over(SDL_Texture* picture, const PresentRect& shown);

  private:
    void draw_mask(const PresentRect& shown, int rows);
    void draw_glow(SDL_Texture* picture, int width, int height, const PresentRect& shown);

    SDL_Renderer* renderer_;
    Owned<SDL_Texture> mask_, glow_;
    int mask_rows_ = 0;
};

}  // namespace oblong
