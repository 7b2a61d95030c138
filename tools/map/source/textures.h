#pragma once

#include <array>
#include <map>
#include <string>
#include <vector>

#include "tools/map/source/checks.h"
#include "tools/map/source/map_file.h"

namespace oblong::map {

/// u = axes[0] . p + offset[0], v likewise, in texels.
struct TexInfo {
    std::array<Point, 2> axes;
    std::array<double, 2> offset{};
    int texture = 0;          ///< index into TextureList::names()
    bool is_special = false;  ///< sky or liquid: no lightmap, no limit of extent
    SurfaceLight light;

    bool operator==(const TexInfo&) const = default;

    double texel(int axis, const Point& point) const {
        const auto i = static_cast<std::size_t>(axis);
        return dot(axes[i], point) + offset[i];
    }
};

/// A rotation by an angle.
struct Turn {
    double cosine = 1, sine = 0;
};
/// Exact for quarter turns. `degrees`: below 2^31 quarter turns.
Turn turn_of(double degrees);

/// The axes of u and v, before the scale, of a side whose plane has the outward `normal`.
std::array<Point, 2> texture_axes(const TextureFields& fields, const Point& normal);

struct TextureUse {
    std::string name;
    int line = 0;  ///< of its first use in the map source
};

/// All textures and texture alignments of a level's drawn sides.
class TextureList {
  public:
    /// The index of the TexInfo of a side whose plane has the outward `normal`, or -1 if its texture is not drawn.
    int find_or_add(const MapSide& side, const Point& normal);
    /// The index of a texture's name, which may be only on an entity.
    int find_or_add_name(const TextureUse& use);

    const std::vector<TexInfo>& texinfos() const { return texinfos_; }
    const std::vector<TextureUse>& names() const { return names_; }

  private:
    std::vector<TexInfo> texinfos_;
    std::vector<TextureUse> names_;
};

/// The textures of a WAD2 file: each as the bytes of its miptex, by its name in lower case.
class Wad {
  public:
    /// Reads the bytes of a file, throwing InputError.
    explicit Wad(const std::string& bytes);

    /// The miptex's bytes, or null.
    const std::string* find(const std::string& name) const;
    void add_names(NearestName& nearest) const;

    std::string source;  ///< its name in the map, at `line`; 0: not from the map
    int line = 0;

  private:
    std::map<std::string, std::string> textures_;
};

/// The bytes of each named texture, from the first WAD that has it, followed by the other frames of the animated ones
/// ("+0name": the existing ones of +0 to +9 and +a to +j). One that is missing, or that the engine could not draw, is a
/// checkerboard and a warning that names it and its map line.
std::vector<std::string> collect_textures(const std::vector<TextureUse>& uses, const std::vector<Wad>& wads,
                                          Warnings& warnings);

}  // namespace oblong::map
