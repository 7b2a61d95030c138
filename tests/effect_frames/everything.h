#pragma once

#include "engine/files/files.h"
#include "tests/effect_frames/effect_stage.h"
#include "tests/support/folders.h"
#include "tools/gallery/mesh_scene.h"

/// A room that calls for every effect at once (tools/effect_costs/all_effects.map).
namespace oblong::test {

/// A level's entities do not name meshes here: they are placed.
inline const Mesh& ball() {
    static const Mesh mesh = ball_mesh(24, 8, checkered_skin(64, 16, 80));
    return mesh;
}

inline std::vector<PlacedMesh> ball_at(const Vec3<World>& position) {
    PlacedMesh placed;
    placed.mesh = &ball();
    placed.position = position;
    return {placed};
}

inline EffectStage everything(const Camera& camera) {
    const std::filesystem::path assets = std::filesystem::path(test::build_folder()) / "assets";
    const std::string source = read_text(test::source_folder() + "/tools/effect_costs/all_effects.map");
    const std::vector<map::Wad> wads{map::Wad(read_text((assets / "demo.wad").string()))};
    return {engine_level(map::compile_map(map::parse_map(source), wads, {true})), camera,
            make_colormap(read_palette(read_file_bytes(assets / "palette.lmp"))), ball_at(point_at(60, 40, 60))};
}

inline Camera in_tank() {
    return camera_at(point_at(-310, 0, 120), 0, 8);
}

inline Camera before_tank() {
    return camera_at(point_at(-280, 0, 120), 0, 8);
}

}  // namespace oblong::test
