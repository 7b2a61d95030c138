#pragma once

#include "engine/platform/sdl/owned.h"
#include "engine/view/present_rect.h"

namespace oblong {

/// Makes the picture in a window look like that of a tube. Its textures are made when a picture is first drawn.
class CrtLook {
  public:
    /// The renderer outlives it.
    explicit CrtLook(SDL_Renderer* renderer) : renderer_(renderer) {}

    /// Draws over a picture that is shown in `shown`: scanlines and a mask, then the glow around what is bright. Leaves
    /// out what the renderer can't do.
    void draw_over(SDL_Texture* picture, const PresentRect& shown);

  private:
    void draw_mask(const PresentRect& shown, int rows);
    void draw_glow(SDL_Texture* picture, int width, int height, const PresentRect& shown);

    SDL_Renderer* renderer_;
    Owned<SDL_Texture> mask_, glow_;
    int mask_rows_ = 0;
};

}  // namespace oblong
