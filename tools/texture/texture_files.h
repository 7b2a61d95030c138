#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/level/level.h"
#include "engine/pictures/picture.h"
#include "engine/surface/palette.h"

namespace oblong {

/// How the colours of a picture are converted to a palette.
struct PngColours {
    bool may_glow = false;  ///< the palette's last 32 colours may be used
    Dither dither = Dither::None;
};

/// "none" or "floyd-steinberg", the value of --dither. Throws UsageError.
Dither parse_dither(const std::string& text);

/// All these throw FileError.

/// A picture (PNG, TGA, JPEG, BMP) as a texture named after its file. Its sizes must be multiples of 16, 4096 at most.
/// An indexed PNG with this palette (or its beginning) keeps its indices; any other is converted by `colours`.
/// Transparent pixels become holes in a texture whose name begins with '{'; in any other they are an error.
MipTexture picture_texture(const std::string& path, std::span<const std::uint8_t> bytes, const Palette& palette,
                           PngColours colours = {});

using TextureWarnings = std::vector<std::string>;

/// The pictures in a folder, sorted; none is an error.
std::vector<std::string> pictures_in(const std::string& folder);

/// The bytes of a WAD of pictures: those named in `glowing` may use glowing colours. Warns of pictures that are no
/// textures, as picture_texture() reads them; if none is left, that is an error, as two of one name are, ignoring
/// case.
std::vector<std::uint8_t> packed_textures(const std::vector<std::string>& picture_paths,
                                          const std::vector<std::string>& glowing, const Palette& palette,
                                          Dither dither, TextureWarnings& warnings);

/// `pack`: writes such a WAD; a folder stands for all pictures in it. Throws UsageError if a name in `glowing` is not
/// among them. Warns of animations that stand still and of skies of one colour, too.
TextureWarnings pack_textures(const std::vector<std::string>& paths, const std::vector<std::string>& glowing,
                              const std::string& wad_path, const Palette& palette, Dither dither = Dither::None);

/// `unpack`: the textures of a WAD or a BSP as indexed PNGs into a folder, which is created. Warns of textures of a WAD
/// that are left out, as they are damaged, or second ones for a file; throws FileError if none is left.
TextureWarnings unpack_textures(const std::string& archive_path, const std::string& folder, const Palette& palette);

/// "*water" -> "#water.png". Slashes, which a name in a broken file may hold, become '_'.
std::string file_of_texture_name(const std::string& name);

/// The PNG of a palette's colormap: a row of cells for each of the 256 colours, its shades from the brightest on the
/// left to the darkest on the right.
std::vector<std::uint8_t> make_ramp_sheet(const Palette& palette);

/// A texture with its four mip levels. A texel of level n is the palette colour nearest to the mean of the 2^n x 2^n
/// texels of level 0 under it: a glowing colour if half of them or more glow, and else an ordinary one, so that nothing
/// starts to glow with distance. In a texture with holes, a texel is a hole if half of those under it are, else the
/// mean of the others. `texels` are width * height; both sizes are multiples of 16.
MipTexture make_mip_texture(const std::string& name, std::int32_t width, std::int32_t height,
                            std::vector<std::uint8_t> texels, const Palette& palette);

inline constexpr std::uint8_t kHole = 255;  ///< where a texture has_holes()

}  // namespace oblong
