#include "tools/gallery/mesh_shapes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <utility>

#include "engine/base/table.h"
#include "engine/view/screen.h"
#include "tools/gallery/numbers.h"

namespace oblong {

Skin checkered_skin(std::int32_t size, std::uint8_t one, std::uint8_t other) {
    Skin skin{"checkered", size, size, std::vector<std::uint8_t>(pixel_count(size, size))};
    for (std::int32_t v = 0; v < size; ++v)
        for (std::int32_t u = 0; u < size; ++u) at(skin.texels, v * size + u) = (u / 8 + v / 8) % 2 == 0 ? one : other;
    return skin;
}

Skin plain_skin(std::uint8_t colour) {
    return {"plain", 1, 1, {colour}};
}

Mesh ball_mesh(double radius, int rings, Skin skin) {
    Mesh mesh;
    const int around = 2 * rings;
    MeshFrame frame{"ball", {}, {}, {}};
    for (int ring = 0; ring <= rings; ++ring)
        for (int step = 0; step <= around; ++step) {
            const double down = std::numbers::pi * ring / rings, turn = 2 * std::numbers::pi * step / around;
            const double x = std::sin(down) * std::cos(turn), y = std::sin(down) * std::sin(turn), z = std::cos(down);
            frame.vertices.push_back({world_point(radius * x, radius * y, radius * z), unit_vector(x, y, z)});
            mesh.texels.push_back({Texel::from_raw(std::int64_t{skin.width - 1} * 65536 * step / around),
                                   Texel::from_raw(std::int64_t{skin.height - 1} * 65536 * ring / rings)});
        }
    for (int ring = 0; ring < rings; ++ring)
        for (int step = 0; step < around; ++step) {
            const auto upper = static_cast<std::uint32_t>(ring * (around + 1) + step),
                       lower = upper + static_cast<std::uint32_t>(around) + 1;
            if (ring > 0) mesh.triangles.push_back({{upper, upper + 1, lower}, 0});
            if (ring < rings - 1) mesh.triangles.push_back({{upper + 1, lower + 1, lower}, 0});
        }
    set_box(frame);
    mesh.frames.push_back(frame);
    mesh.skins.push_back(std::move(skin));
    return mesh;
}

Mesh cube_mesh(double half_size, Skin skin) {
    Mesh mesh;
    MeshFrame frame{"cube", {}, {}, {}};
    const double w = skin.width, h = skin.height;
    for (int axis = 0; axis < 3; ++axis)
        for (const int sign : {-1, 1}) {
            const auto first = static_cast<std::uint32_t>(frame.vertices.size());
            for (const auto& [a, b] : {std::pair{-1, -1}, std::pair{1, -1}, std::pair{1, 1}, std::pair{-1, 1}}) {
                double p[3] = {}, n[3] = {};
                p[axis] = sign * half_size;
                n[axis] = sign;
                p[(axis + 1) % 3] = a * half_size;
                p[(axis + 2) % 3] = b * half_size;
                frame.vertices.push_back({world_point(p[0], p[1], p[2]), unit_vector(n[0], n[1], n[2])});
                mesh.texels.push_back({Texel::from_raw(std::lround((a + 1) * w * 32768)),
                                       Texel::from_raw(std::lround((1 - b) * h * 32768))});
            }
            if (sign > 0) {
                mesh.triangles.push_back({{first, first + 2, first + 1}, 0});
                mesh.triangles.push_back({{first, first + 3, first + 2}, 0});
            } else {
                mesh.triangles.push_back({{first, first + 1, first + 2}, 0});
                mesh.triangles.push_back({{first, first + 2, first + 3}, 0});
            }
        }
    set_box(frame);
    mesh.frames.push_back(frame);
    mesh.skins.push_back(std::move(skin));
    return mesh;
}

}  // namespace oblong
