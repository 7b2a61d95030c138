#pragma once

#include <cstdint>

#include "engine/surface/palette.h"
#include "engine/view/screen.h"

namespace oblong::dos {

/// The VGA's modes of 256 colours: mode 13h, which the BIOS knows, and those "X" that its registers can do besides.
struct VgaMode {
    std::int32_t width_px, height_px;
    bool operator==(const VgaMode&) const = default;
};

/// The screen of a VGA.
class Vga {
  public:
    /// Shows a picture, of 320x200, 320x240, 320x400 or 360x480 pixels as it is; of another size the nearest pixels, in
    /// 320x200. Colours have 6 bits each. They change while nothing is shown.
    void show(Framebuffer picture, const Palette& palette);
    /// Until the beam goes back to the top, 70 times a second (60 in 240 and 480 lines).
    void wait_for_retrace();

  private:
    void set_mode(VgaMode mode);
    void set_palette(const Palette& palette);

    VgaMode mode_{320, 200};  // as the loader has set it
    Palette palette_;
    bool has_palette_ = false;
};

}  // namespace oblong::dos
