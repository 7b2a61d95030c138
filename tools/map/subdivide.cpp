#include "tools/map/subdivide.h"

#include <algorithm>
#include <string>

#include "engine/base/input_error.h"

namespace oblong::map {
namespace {

constexpr double kStep = 16;

struct Span {
    double low = 0, high = 0;
};

Span texel_span(const Winding& winding, const TexInfo& texinfo, int axis) {
    Span span{texinfo.texel(axis, winding[0]), texinfo.texel(axis, winding[0])};
    for (const Point& point : winding) {
        span.low = std::min(span.low, texinfo.texel(axis, point));
        span.high = std::max(span.high, texinfo.texel(axis, point));
    }
    return span;
}

Plane plane_at_texel(const TexInfo& texinfo, int axis, double texel) {
    const auto i = static_cast<std::size_t>(axis);
    const double size = length(texinfo.axes[i]);
    return {scaled(texinfo.axes[i], 1 / size), (texel - texinfo.offset[i]) / size};
}

// The format counts faces with 16 bits.
constexpr std::size_t kMostSurfaces = 65535;

void check_count(std::size_t count) {
    if (count > kMostSurfaces)
        throw InputError("lump faces", "more than " + std::to_string(kMostSurfaces) +
                                           " faces, expected larger texture scales or a smaller level");
}

// A hair over a whole step is no reason to cut: the reader rounds the same numbers.
std::vector<Winding> cut_along(Winding winding, const TexInfo& texinfo, int axis) {
    std::vector<Winding> pieces;
    while (true) {
        const Span span = texel_span(winding, texinfo, axis);
        const double cut = std::floor(span.low / kStep + kOnEpsilon) * kStep + kMaxExtent;
        if (span.high <= cut + kStep * kOnEpsilon) break;
        SplitWinding parts = split(winding, plane_at_texel(texinfo, axis, cut));
        if (parts.front.empty() || parts.back.empty()) break;
        pieces.push_back(std::move(parts.back));
        check_count(pieces.size());
        winding = std::move(parts.front);
    }
    pieces.push_back(std::move(winding));
    return pieces;
}

}  // namespace

std::vector<Surface> subdivided(std::vector<Surface> surfaces, const std::vector<TexInfo>& texinfos) {
    std::vector<Surface> result;
    for (Surface& surface : surfaces) {
        const TexInfo& texinfo = texinfos[static_cast<std::size_t>(surface.texinfo)];
        if (texinfo.is_special) {
            result.push_back(std::move(surface));
            continue;
        }
        for (Winding& strip : cut_along(std::move(surface.winding), texinfo, 0)) {
            for (Winding& piece : cut_along(std::move(strip), texinfo, 1))
                result.push_back({surface.node, surface.plane, surface.texinfo, std::move(piece)});
            check_count(result.size());
        }
    }
    return result;
}

}  // namespace oblong::map
