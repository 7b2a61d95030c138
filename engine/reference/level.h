#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/reference/vec.h"

namespace oblong::reference {

/// normal . p >= offset is inside.
struct Plane {
    Vec normal;
    double offset = 0;
};

/// The mapping of a texture on faces: u = dot(s, p) + s_offset, v = dot(t, p) + t_offset, texels of mip level 0.
struct TexInfo {
    Vec s, t;
    double s_offset = 0, t_offset = 0;
    int texture = 0;
    bool is_special = false;  ///< the file's flag for faces without light
};

/// Mip level 0 of a texture: palette indices, rows top to bottom.
struct Texture {
    std::string name;
    int width = 0, height = 0;
    std::vector<std::uint8_t> texels;
};

enum class Material { Lit, Liquid, Sky, Unlit };

/// A polygon, clockwise seen from its front.
struct Face {
    Plane plane;               ///< the file's, oriented so that the face is visible where normal . p > offset
    std::vector<int> corners;  ///< into Level::vertices, with the vertices inside its edges (EdgeMender)
    int texinfo = 0;
    Material material = Material::Lit;
    std::array<std::uint8_t, 4> styles{};  ///< a lightmap for each, up to the first 255
    int light_offset = -1;                 ///< into Level::lighting; -1: no lightmap
    int first_u = 0, first_v = 0;          ///< texels: of the first light sample
    int light_columns = 0, light_rows = 0;

    int style_count() const;
};

/// Faces [first_face, first_face + face_count), and the box of their brushes. Model 0 is the world.
struct Model {
    Vec mins, maxs;
    int first_face = 0, face_count = 0;
};

/// The visible part of a level, in the file's units and with its floats.
struct Level {
    std::vector<Vec> vertices;
    std::vector<TexInfo> texinfos;
    std::vector<Texture> textures;
    std::vector<Face> faces;
    std::vector<std::uint8_t> lighting;
    std::vector<std::uint8_t> coloured_lighting;  ///< red, green and blue of each value of `lighting`; or empty
    std::vector<Model> models;

    const TexInfo& texinfo_of(const Face& face) const { return texinfos[static_cast<std::size_t>(face.texinfo)]; }
    const Texture& texture_of(const Face& face) const {
        return textures[static_cast<std::size_t>(texinfo_of(face).texture)];
    }
    const Face& face(int index) const { return faces[static_cast<std::size_t>(index)]; }
    const Vec& vertex(int index) const { return vertices[static_cast<std::size_t>(index)]; }
};

/// A level from the bytes of a file of BSP version 29, BSP2 or 2PSB. Throws std::runtime_error naming the lump for a
/// file that ends too early or has invalid references.
Level read_level(std::span<const std::uint8_t> file);

}  // namespace oblong::reference
