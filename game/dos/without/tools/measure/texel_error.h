#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/frame/frame_record.h"
#include "engine/scene/placed_models.h"
#include "tools/measure/exact.h"
#include "tools/reference/level.h"

// A substitute for what the lab uses of the header of the same name: nothing is measured (see tools/reference/level.h
// beside this).

namespace oblong {

struct ErrorSummary {
    std::int64_t count = 0;
    double rms = 0, p99 = 0, max = 0;
};

struct TexelError {
    float pixels = -1, texels = -1;
    bool is_measured() const { return pixels >= 0; }
};

class TexelErrorMeter {
  public:
    TexelErrorMeter(const reference::Level&, std::span<const PlacedModel>, const Camera&, const ScreenMode&, bool) {}
    std::vector<TexelError> measure(const FrameRecord&) { return {}; }
};

inline std::vector<std::int32_t> true_faces(const reference::Level&, std::span<const PlacedModel>, const Camera&,
                                            const ScreenMode&, bool) {
    return {};
}
inline std::int64_t wrong_faces(const FrameRecord&, std::span<const std::int32_t>) {
    return 0;
}

inline ErrorSummary summarize_errors(std::vector<float>) {
    return {};
}
inline ErrorSummary summarize_pixels(std::span<const TexelError>) {
    return {};
}

}  // namespace oblong
