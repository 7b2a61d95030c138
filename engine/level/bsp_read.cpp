#include "engine/level/bsp_read.h"

#include "engine/level/bsp_parts.h"
#include "engine/level/entities.h"

namespace oblong {

namespace {

std::vector<std::uint8_t> copy_lump(const BspFile& file, Lump lump) {
    const auto bytes = file.lump_bytes(lump);
    return {bytes.begin(), bytes.end()};
}

std::vector<Entity> read_entities(const BspFile& file) {
    const auto bytes = file.lump_bytes(Lump::Entities);
    const std::string text(bytes.begin(), bytes.end());
    return parse_entities(text, "lump 'entities'", file.range(Lump::Entities).offset);
}

void read_geometry(const BspFile& file, Level& level) {
    level.planes = read_planes(file);
    level.vertices = read_vertices(file);
    level.edges = read_edges(file);
    level.surf_edges = read_surf_edges(file);
    level.textures = read_textures(file);
    for (const TextureIndex texture : level.textures.indices())
        if (level.sky.is_none() && material_of_texture(level.textures[texture].name) == Material::Sky)
            level.sky = texture;
    level.texinfos = read_texinfos(file, level);
    level.faces = read_faces(file, level, read_vertex_floats(file));
    level.lighting = copy_lump(file, Lump::Lighting);
}

void read_trees(const BspFile& file, Level& level) {
    level.mark_faces = read_mark_faces(file);
    level.nodes = read_nodes(file);
    level.clip_nodes = read_clip_nodes(file);
    level.leaves = read_leaves(file);
    level.models = read_models(file);
    check_node_tree(file, level.nodes);
    check_clip_nodes(file, level.clip_nodes);
}

void read_visibility(const BspFile& file, Level& level) {
    level.visibility = copy_lump(file, Lump::Visibility);
    if (level.visibility.empty())
        for (Leaf& leaf : level.leaves) leaf.visibility_offset = -1;
    check_visibility(file, level);
}

}  // namespace

Level read_bsp(std::span<const std::uint8_t> bytes) {
    const BspFile file = open_bsp(bytes);
    Level level;
    level.entities = read_entities(file);
    read_geometry(file, level);
    read_trees(file, level);
    read_visibility(file, level);
    return level;
}

std::vector<MipTexture> read_bsp_textures(std::span<const std::uint8_t> bytes) {
    const Table<MipTexture> textures = read_textures(open_bsp(bytes));
    return {textures.begin(), textures.end()};
}

}  // namespace oblong
