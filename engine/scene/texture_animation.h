#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "engine/level/level.h"

namespace oblong {

/// Textures shown in turn: those named `+0name` to `+9name`, and `+aname` to `+jname`, which are shown instead while
/// the model is switched (a pressed button). All faces of a sequence show the same frame, whichever of them they name.
class TextureAnimations {
  public:
    static constexpr std::int64_t kFrameMs = 200;  ///< a frame's time, as in Quake
    static constexpr int kMostFrames = 10;

    TextureAnimations() = default;
    /// A sequence with a gap, a frame twice or frames of different sizes stands still, and a warning is added.
    TextureAnimations(const Level& level, std::vector<std::string>& warnings);

    bool is_empty() const { return sequences_.empty(); }
    /// Whether the texture ever changes: by time, or when its model is switched.
    bool is_animated(TextureIndex texture) const { return !is_empty() && !of_texture_[texture].normal.is_none(); }
    /// The texture that stands for another one at a time from 0 on.
    TextureIndex shown(TextureIndex texture, bool is_switched, std::int64_t time_ms) const;

  private:
    using Sequence = std::vector<TextureIndex>;
    /// A texture's own sequence and the one of a switched model; both none: it stands still.
    struct Pair {
        Index<Sequence> normal = Index<Sequence>::none(), switched = Index<Sequence>::none();
    };

    void add(const Sequence& digits, const Sequence& letters);

    Table<Sequence> sequences_;
    Table<Pair, MipTexture> of_texture_;  ///< empty if there are no sequences
};

}  // namespace oblong
