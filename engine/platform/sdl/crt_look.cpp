#include "engine/platform/sdl/crt_look.h"

#include <vector>

#include "engine/platform/crt_mask.h"

namespace oblong {
namespace {

constexpr std::uint8_t kGlow = 90;  // of 255: makes up for the mask's loss of light

bool has_size(SDL_Texture* texture, int width, int height) {
    int is_width = 0, is_height = 0;
    return texture != nullptr && SDL_QueryTexture(texture, nullptr, nullptr, &is_width, &is_height) == 0 &&
           is_width == width && is_height == height;
}

}  // namespace

void CrtLook::draw_over(SDL_Texture* picture, const PresentRect& shown) {
    int width = 0, height = 0;
    SDL_QueryTexture(picture, nullptr, nullptr, &width, &height);
    if (shown.width_px <= 0 || shown.height_px <= 0 || width < 2 || height < 2) return;
    draw_mask(shown, height);
    draw_glow(picture, width, height, shown);
}

void CrtLook::draw_mask(const PresentRect& shown, int rows) {
    if (!has_size(mask_.get(), shown.width_px, shown.height_px) || mask_rows_ != rows) {
        mask_.reset(SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_STATIC, shown.width_px,
                                      shown.height_px));
        mask_rows_ = rows;
        if (!mask_) return;
        const std::vector<std::uint32_t> pixels = make_crt_mask(shown.width_px, shown.height_px, rows);
        SDL_UpdateTexture(mask_.get(), nullptr, pixels.data(), shown.width_px * 4);
        SDL_SetTextureBlendMode(mask_.get(), SDL_BLENDMODE_MOD);
    }
    const SDL_Rect target{shown.x_px, shown.y_px, shown.width_px, shown.height_px};
    SDL_RenderCopy(renderer_, mask_.get(), nullptr, &target);
}

// Adds a half-size copy, enlarged, to the picture.
void CrtLook::draw_glow(SDL_Texture* picture, int width, int height, const PresentRect& shown) {
    if (!has_size(glow_.get(), width / 2, height / 2)) {
        glow_.reset(
            SDL_CreateTexture(renderer_, SDL_PIXELFORMAT_ARGB8888, SDL_TEXTUREACCESS_TARGET, width / 2, height / 2));
        if (!glow_) return;
        SDL_SetTextureScaleMode(glow_.get(), SDL_ScaleModeLinear);
        SDL_SetTextureBlendMode(glow_.get(), SDL_BLENDMODE_ADD);
        SDL_SetTextureAlphaMod(glow_.get(), kGlow);
    }
    if (SDL_SetRenderTarget(renderer_, glow_.get()) != 0) return;
    SDL_SetTextureScaleMode(picture, SDL_ScaleModeLinear);
    SDL_RenderCopy(renderer_, picture, nullptr, nullptr);
    SDL_SetTextureScaleMode(picture, SDL_ScaleModeNearest);
    SDL_SetRenderTarget(renderer_, nullptr);
    const SDL_Rect target{shown.x_px, shown.y_px, shown.width_px, shown.height_px};
    SDL_RenderCopy(renderer_, glow_.get(), nullptr, &target);
}

}  // namespace oblong
