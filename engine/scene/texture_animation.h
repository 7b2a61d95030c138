#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// Animated textures: the sequence `+0name` to `+9name`, and `+aname` to `+jname`, shown instead while the model is
/// switched (a pressed button). All faces with a texture of a sequence show the same frame.
class TextureAnimations {
  public:
    static constexpr std::int64_t kFrameMs = 200;  ///< duration of a frame, as in Quake
    static constexpr int kMostFrames = 10;

    TextureAnimations() = default;
    /// A sequence with a gap, a duplicate frame or frames of different sizes is not animated; a warning is added.
    TextureAnimations(const Level& level, std::vector<std::string>& warnings);

    bool is_empty() const { return sequences_.empty(); }
    /// Whether the texture changes over time or when its model is switched.
    bool is_animated(TextureIndex texture) const { return !is_empty() && !of_texture_[texture].normal.is_none(); }
    /// The texture to show in place of `texture` at time_ms >= 0.
    TextureIndex shown(TextureIndex texture, bool is_switched, std::int64_t time_ms) const;

  private:
    using Sequence = std::vector<TextureIndex>;
    /// The sequences of a texture while its model is not switched and while it is; both none: not animated.
    struct Pair {
        Index<Sequence> normal = Index<Sequence>::none(), switched = Index<Sequence>::none();
    };

    void add(const Sequence& digits, const Sequence& letters);

    Table<Sequence> sequences_;
    Table<Pair, MipTexture> of_texture_;  ///< empty if there are no sequences
};

}  // namespace oblong
