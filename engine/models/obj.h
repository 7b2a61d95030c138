#pragma once

#include <string>
#include <vector>

#include "engine/mesh/mesh.h"
#include "engine/pictures/picture.h"

namespace oblong {

struct ObjOptions {
    double scale = 1;              ///< world units of a unit of the file, above 0
    bool is_z_up = false;          ///< the file has the world's axes; else y is up and z ahead, as most programs write
    Dither dither = Dither::None;  ///< of skins
    std::vector<std::string> glasses = {};  ///< materials that may stand for "glass": skins of the mesh from 1 on
    Skin plain = {};                        ///< of faces without a material; without texels: grey
};

/// A scale in 256ths of the file's size, for callers without floating point.
ObjOptions scaled_256(std::int32_t scale_256);

struct ObjModel {
    Mesh mesh;                          ///< of one frame
    std::vector<std::string> warnings;  ///< of missing parts of the file, with their replacements
};

/// A Wavefront OBJ file with its materials (by tinyobjloader), a skin for each used material: the picture of its
/// map_Kd (with its options -s and -o), or a texel of its colour Kd. A missing material file, material or picture is a
/// warning, and replaced by grey. Coordinates are rounded to 1/4,096 unit once, after scaling: a model of a unit's size
/// loses nothing if `scale` gives it its final size. Faces may be polygons of up to 255 corners, concave ones too.
/// Missing normals are computed: smooth within a smoothing group, flat where that is off, and smooth everywhere in a
/// file that names no groups. Normals that faces name in vain count as missing. Throws FileError with the line for
/// invalid or too large numbers, faces of fewer than three corners, corners that the file does not have, a file without
/// faces.
ObjModel read_obj(const std::string& path, const Palette& palette, const ObjOptions& options = {});
/// The same for a file in memory, whose materials are beside `path`. Throws InputError.
ObjModel read_obj(std::span<const std::uint8_t> bytes, const std::string& path, const Palette& palette,
                  const ObjOptions& options);

}  // namespace oblong
