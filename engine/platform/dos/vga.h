#pragma once

#include <cstdint>

#include "engine/surface/palette.h"
#include "engine/view/screen.h"

namespace oblong::dos {

/// A 256-colour mode of the VGA: mode 13h of the BIOS, or a "mode X" set through registers.
struct VgaMode {
    std::int32_t width_px, height_px;
    bool operator==(const VgaMode&) const = default;
};

/// The screen of a VGA.
class Vga {
  public:
    /// Shows a picture: 320x200, 320x240, 320x400 or 360x480 pixels unchanged, other sizes as nearest pixels in
    /// 320x200. Colours have 6 bits a channel, and change during the retrace.
    void show(Framebuffer picture, const Palette& palette);
    /// Waits for the vertical retrace, 70 times a second (60 with 240 and 480 lines).
    void wait_for_retrace();

  private:
    void set_mode(VgaMode mode);
    void set_palette(const Palette& palette);

    VgaMode mode_{320, 200};  // as the loader has set it
    Palette palette_;
    bool has_palette_ = false;
};

}  // namespace oblong::dos
