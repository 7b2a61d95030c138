#include "engine/mesh/mesh.h"

#include <algorithm>
#include <cstdlib>
#include <map>
#include <optional>

#include "engine/base/table.h"
#include "engine/fixed/arithmetic.h"

namespace oblong {

namespace {

using Corners = std::array<std::uint32_t, 3>;
using NormalSum = std::array<std::int64_t, 3>;  ///< of products of two World raw numbers, without their last bits

/// Outward, of twice the triangle's area in length: corners are clockwise.
auto normal_of(const std::vector<MeshVertex>& vertices, const Corners& corners) {
    const Vec3<World> a = item(vertices, corners[0]).position;
    return cross(item(vertices, corners[2]).position - a, item(vertices, corners[1]).position - a);
}

/// How many low bits of the normals to drop so that the sum of all fits 64 bits.
int bits_too_many(const std::vector<MeshVertex>& vertices, std::span<const Corners> triangles) {
    std::int64_t largest = 0;
    for (const Corners& corners : triangles)
        for (const std::int64_t part : raw_of(normal_of(vertices, corners)))
            largest = std::max(largest, std::abs(part));
    const int bits = log2_floor(static_cast<std::uint64_t>(largest) | 1) + log2_floor(triangles.size() | 1) + 2;
    return std::max(bits - 62, 0);
}

/// None if a part of the normal does not fit.
std::optional<FacingPlane> plane_of(const std::vector<MeshVertex>& vertices, const Corners& corners) {
    const auto normal = normal_of(vertices, corners);
    const auto short_normal = saturating_convert<Fixed<std::int32_t, 24>>(normal);
    if (convert<Fixed<std::int64_t, 24>>(short_normal) != normal) return std::nullopt;
    return FacingPlane{short_normal, dot(short_normal, item(vertices, corners[0]).position)};
}

MeshBox box_at(const Vec3<World>& p) {
    return {p, p};
}

void extend(MeshBox& box, const Vec3<World>& p) {
    box.mins = {std::min(box.mins.x, p.x), std::min(box.mins.y, p.y), std::min(box.mins.z, p.z)};
    box.maxs = {std::max(box.maxs.x, p.x), std::max(box.maxs.y, p.y), std::max(box.maxs.z, p.z)};
}

}  // namespace

std::uint32_t shown_at(const MeshSequence& sequence, std::int64_t time_ms) {
    if (sequence.ends_ms.empty()) return sequence.first;
    const std::int64_t length_ms = sequence.ends_ms.back();
    const std::int64_t since_ms = (time_ms % length_ms + length_ms) % length_ms;
    const auto shown = std::upper_bound(sequence.ends_ms.begin(), sequence.ends_ms.end(), since_ms);
    return sequence.first + static_cast<std::uint32_t>(shown - sequence.ends_ms.begin());
}

void set_normals(std::vector<MeshVertex>& vertices, std::span<const Corners> triangles) {
    const int dropped_bits = bits_too_many(vertices, triangles);
    std::vector<NormalSum> sums(vertices.size());
    for (const Corners& corners : triangles) {
        const NormalSum normal = raw_of(normal_of(vertices, corners));
        for (const std::uint32_t corner : corners)
            for (std::size_t axis = 0; axis < 3; ++axis)
                item(sums, corner)[axis] += floor_shift(normal[axis], dropped_bits);
    }
    for (const Corners& corners : triangles)
        for (const std::uint32_t corner : corners)
            if (item(sums, corner) == NormalSum{}) item(sums, corner) = raw_of(normal_of(vertices, corners));
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        if (sums[i] == NormalSum{}) sums[i] = {0, 0, 1};
        const auto unit = normalised_raw(sums[i]);
        vertices[i].normal = {unit[0], unit[1], unit[2]};
    }
}

void set_boxes(MeshFrame& frame, std::span<const MeshTriangle> triangles) {
    if (frame.vertices.empty()) return;
    MeshBox box = box_at(frame.vertices.front().position);
    for (const MeshVertex& vertex : frame.vertices) extend(box, vertex.position);
    frame.mins = box.mins;
    frame.maxs = box.maxs;
    frame.parts.clear();
    if (triangles.size() <= kPartTriangles) return;
    for (std::size_t i = 0; i < triangles.size(); ++i) {
        if (i % kPartTriangles == 0)
            frame.parts.push_back(box_at(item(frame.vertices, triangles[i].vertices[0]).position));
        for (const std::uint32_t vertex : triangles[i].vertices)
            extend(frame.parts.back(), item(frame.vertices, vertex).position);
    }
}

std::vector<FacingPlane> facing_planes(const Mesh& mesh) {
    std::vector<FacingPlane> planes;
    if (mesh.frames.size() != 1) return planes;
    const std::vector<MeshVertex>& vertices = mesh.frames.front().vertices;
    for (const MeshTriangle& triangle : mesh.triangles) {
        const auto& [a, b, c] = triangle.vertices;
        if (std::max({a, b, c}) >= vertices.size()) return {};
        const std::optional<FacingPlane> plane = plane_of(vertices, triangle.vertices);
        if (!plane) return {};
        planes.push_back(*plane);
    }
    return planes;
}

std::vector<std::uint32_t> shared_places(const Mesh& mesh) {
    std::vector<std::uint32_t> places;
    if (mesh.frames.size() != 1) return places;
    std::map<std::array<std::int64_t, 3>, std::uint32_t> first;
    for (const MeshVertex& vertex : mesh.frames.front().vertices)
        places.push_back(
            first.try_emplace(raw_of(vertex.position), static_cast<std::uint32_t>(places.size())).first->second);
    return places;
}

}  // namespace oblong
