#pragma once

#include <vector>

#include "engine/mesh/draw_mesh.h"
#include "tests/support/palettes.h"
#include "tests/support/random.h"
#include "tests/support/views.h"
#include "tools/gallery/mesh_scene.h"
#include "tools/gallery/row.h"

namespace oblong::test {

/// A picture with the depth of its pixels, at first infinitely far and of colour 255.
struct MeshPicture {
    explicit MeshPicture(const ViewContext& its_view)
        : view(its_view),
          width(view.projection.width_px),
          height(view.projection.height_px),
          depth(width, height),
          pixels(pixel_count(width, height), 255),
          scratch(height) {
        depth.want({0, width, 0, height});
        depth.clear();
    }

    MeshTarget target() { return {depth, {pixels.data(), width, height, width}, {0, width, 0, height}}; }
    MeshCounts draw(const PlacedMesh& placed, const Colormap& colormap, const MeshLight& light = {},
                    bool is_affine = false, MeshParts parts = {}) {
        return draw_mesh(placed, {view, colormap, light, nullptr, is_affine, parts}, target(), scratch);
    }
    std::uint8_t at(std::int32_t x, std::int32_t y) const { return pixels[static_cast<std::size_t>(y * width + x)]; }
    std::int64_t painted() const { return std::ssize(pixels) - std::count(pixels.begin(), pixels.end(), 255); }

    ViewContext view;
    std::int32_t width, height;
    DepthBuffer depth;
    std::vector<std::uint8_t> pixels;
    MeshScratch scratch;
};

/// A mesh of one frame; normals point up, texels are those given.
struct MeshBuilder {
    Mesh mesh;

    MeshBuilder() { mesh.frames.emplace_back(); }

    std::uint32_t add(const Vec3<World>& position, double u = 0, double v = 0,
                      Vec3<Unit> normal = unit_vector({0, 0, 1})) {
        mesh.frames[0].vertices.push_back({position, normal});
        const auto texel = [](double value) { return Texel::from_raw(std::llround(value * 65536)); };
        mesh.texels.push_back({texel(u), texel(v)});
        return static_cast<std::uint32_t>(mesh.texels.size()) - 1;
    }
    void triangle(std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t skin = 0) {
        mesh.triangles.push_back({{a, b, c}, skin});
    }
    const Mesh& done() {
        set_boxes(mesh.frames[0]);
        return mesh;
    }
};

inline PlacedMesh placed_at(const Mesh& mesh, const Vec3<World>& position = {}) {
    PlacedMesh placed;
    placed.mesh = &mesh;
    placed.position = position;
    return placed;
}

inline void turn_at_random(PlacedMesh& placed, auto& random) {
    placed.yaw = random_angle(random);
    placed.pitch = random_angle(random);
    placed.roll = random_angle(random);
}

/// The columns of a mesh's rotation in doubles, by Quake's AngleVectors.
struct MeshAxes {
    Point ahead, left, up;

    explicit MeshAxes(const PlacedMesh& placed) {
        const double yaw = radians_of(placed.yaw), pitch = radians_of(placed.pitch), roll = radians_of(placed.roll);
        const double sy = std::sin(yaw), cy = std::cos(yaw), sp = std::sin(pitch), cp = std::cos(pitch),
                     sr = std::sin(roll), cr = std::cos(roll);
        ahead = {cp * cy, cp * sy, -sp};
        left = {sr * sp * cy - cr * sy, sr * sp * sy + cr * cy, sr * cp};
        up = {cr * sp * cy + sr * sy, cr * sp * sy - sr * cy, cr * cp};
    }
    Point turned(const Point& p) const { return ahead * p.x + left * p.y + up * p.z; }
};

/// The largest difference of a coordinate.
inline double farthest_apart(const Point& a, const Point& b) {
    return std::max({std::abs(a.x - b.x), std::abs(a.y - b.y), std::abs(a.z - b.z)});
}

}  // namespace oblong::test
