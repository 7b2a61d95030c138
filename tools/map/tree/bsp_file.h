#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "tools/map/source/geometry.h"

namespace oblong::map {

/// Three floats of a level file.
using Floats = std::array<float, 3>;

inline Floats to_floats(const Point& point) {
    return {static_cast<float>(point.x), static_cast<float>(point.y), static_cast<float>(point.z)};
}
inline Point to_point(const Floats& floats) {
    return {static_cast<double>(floats[0]), static_cast<double>(floats[1]), static_cast<double>(floats[2])};
}

/// The lumps of a level file, in the file's order, with its fields; numbers are wider than in the file.
struct FilePlane {
    Floats normal{};
    float distance = 0;
    int type = 0;
};

struct FileBox {
    std::array<int, 3> mins{}, maxs{};
};

struct FileNode {
    int plane = 0;
    std::array<int, 2> children{};  ///< a node, or -1 - a leaf
    FileBox box;
    int first_face = 0, face_count = 0;
};

struct FileTexAxis {
    Floats direction{};
    float offset = 0;

    bool operator==(const FileTexAxis&) const = default;
};

struct FileTexInfo {
    std::array<FileTexAxis, 2> axes;  ///< of u and v
    int texture = 0;
    int flags = 0;  ///< 1: no lightmap

    bool operator==(const FileTexInfo&) const = default;
};

struct FileFace {
    int plane = 0;
    int is_back = 0;
    int first_surf_edge = 0, edge_count = 0;
    int texinfo = 0;
    std::array<std::uint8_t, 4> styles{255, 255, 255, 255};
    int light_offset = -1;
};

struct FileClipNode {
    int plane = 0;
    std::array<int, 2> children{};  ///< a clip node, or contents
};

struct FileLeaf {
    int contents = 0;
    int visibility_offset = -1;
    FileBox box;
    int first_mark_face = 0, mark_face_count = 0;
};

struct FileModel {
    Floats mins{}, maxs{};
    std::array<int, 4> head_nodes{};
    int visible_leaf_count = 0;
    int first_face = 0, face_count = 0;
};

struct BspFile {
    std::string entities;
    std::vector<FilePlane> planes;
    std::vector<std::string> textures;  ///< miptex bytes
    std::vector<Floats> vertices;
    std::string visibility;
    std::vector<FileNode> nodes;
    std::vector<FileTexInfo> texinfos;
    std::vector<FileFace> faces;
    std::string lighting;
    std::string coloured_lighting;  ///< red, green and blue of each sample; empty: all are white
    std::vector<FileClipNode> clip_nodes;
    std::vector<FileLeaf> leaves;
    std::vector<int> mark_faces;
    std::vector<std::array<int, 2>> edges;
    std::vector<int> surf_edges;
    std::vector<FileModel> models;
};

/// The vertices at a face's corners, in order.
std::vector<int> vertices_at(const BspFile& bsp, const FileFace& face);

/// The number of a lump's records, and the most that version 29 can index.
struct LumpCount {
    const char* name;
    std::size_t count = 0, most = 0;
    const char* cure;  ///< how to reduce them
};
std::vector<LumpCount> lump_counts(const BspFile& bsp);

/// Whether a lump is larger than version 29 allows: then it is written as BSP2, which has wider numbers.
bool needs_bsp2(const BspFile& bsp);

/// "3412 faces ...": the contents, and the lumps above half of version 29's limits.
std::string summary_of(const BspFile& bsp);

/// Throws InputError if a number exceeds its field's range.
void check_size(const BspFile& bsp);

/// The bytes of the file, of version 29 or, if required, BSP2. Throws InputError like check_size().
std::string to_bytes(const BspFile& bsp);

/// Reads a file of version 29 or BSP2 from to_bytes(), which would give the same bytes again. Throws InputError for any
/// other file.
BspFile from_bytes(const std::string& bytes);

}  // namespace oblong::map
