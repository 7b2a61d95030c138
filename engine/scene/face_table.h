#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/level/level.h"
#include "engine/scene/effects.h"

namespace oblong {

/// Texels per world unit: 48.16.
using TexelDensity = Fixed<std::int64_t, 16>;

/// How a face is drawn.
enum class FaceKind : std::uint8_t { Lit, Liquid, Sky };

/// What a face of a kind calls for.
constexpr EffectSet effects_of(FaceKind kind) {
    if (kind == FaceKind::Sky) return EffectSet{}.with(Effect::Sky);
    if (kind == FaceKind::Liquid) return EffectSet{}.with(Effect::Liquid);
    return {};
}

/// What every frame would otherwise work out again from a level's faces.
struct FaceTable {
    std::vector<std::int32_t> corners;       ///< of all faces, indices of vertices; those of T-junctions among them
    std::vector<std::size_t> first_corners;  ///< of each face in `corners`, and one past the last
    std::vector<FaceKind> kinds;             ///< of each face
    std::vector<EffectSet> leaf_effects;     ///< what each leaf's faces call for
    std::vector<TexelDensity> density;       ///< of each texinfo: texels of mip level 0 per unit, the denser axis
    std::size_t most_corners = 0;            ///< of any face

    std::span<const std::int32_t> corners_of(std::int32_t face) const {
        const std::size_t first = first_corners[static_cast<std::size_t>(face)];
        return std::span(corners).subspan(first, first_corners[static_cast<std::size_t>(face) + 1] - first);
    }
};

/// The table of a level; its faces keep their indices.
FaceTable make_face_table(const Level& level);

}  // namespace oblong
