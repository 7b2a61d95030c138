#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/frame/face_table.h"
#include "engine/level/level.h"

namespace oblong {

struct PlacedModel;

/// A part of a brush model's face that lies in one leaf of the world.
struct Fragment {
    std::int32_t face = 0, model = 0;  ///< `model`: index into the scene's placed models
    std::uint32_t first_corner = 0, corner_count = 0;
    std::int32_t next = -1;  ///< the next in the same leaf
};

/// Brush models (doors, lifts), cut up by the world's tree so that each part is drawn in front of what lies behind its
/// leaf and behind what lies before it. Nearer models come first in a leaf, and within a model its own tree orders.
class ModelFragments {
  public:
    explicit ModelFragments(const Level& level) : first_(level.leaves.size(), -1), last_(level.leaves.size(), -1) {}

    /// Cuts up the faces of `models` that face the eye.
    void cut(const Level& level, std::span<const PlacedModel> models, const FaceTable& table, const Vec3<World>& eye);
    /// Forgets all.
    void clear();

    std::int32_t first_in(std::int32_t leaf) const { return first_[static_cast<std::size_t>(leaf)]; }
    const Fragment& fragment(std::int32_t index) const { return fragments_[static_cast<std::size_t>(index)]; }
    std::span<const Vec3<World>> corners_of(const Fragment& fragment) const {
        return std::span(corners_).subspan(fragment.first_corner, fragment.corner_count);
    }

  private:
    struct Piece {
        std::int32_t node;
        std::uint32_t first_corner, corner_count;
    };

    /// What is being cut: a face of a placed model.
    struct Cut {
        const Level& level;
        const Face& face;
        std::int32_t face_index, model_index;
    };

    void cut_model(const Level& level, const PlacedModel& placed, std::int32_t model_index, const FaceTable& table,
                   const Vec3<World>& eye);
    void cut_face(const Cut& cut, const Vec3<World>& offset, const FaceTable& table);
    void cut_piece(const Cut& cut, const Piece& piece);
    void split(const Piece& piece, const Node& node);
    void add_to_leaf(const Cut& cut, std::int32_t leaf, const Piece& piece);

    std::vector<std::int32_t> first_, last_;  ///< of each leaf; -1: none
    std::vector<std::int32_t> touched_;       ///< leaves that have any
    std::vector<Fragment> fragments_;
    std::vector<Vec3<World>> corners_;
    std::vector<Piece> pieces_;
    std::vector<std::int64_t> distances_;
    std::vector<std::int32_t> order_, nodes_, faces_;
};

}  // namespace oblong
