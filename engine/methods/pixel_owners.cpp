#include "engine/methods/pixel_owners.h"

#include <algorithm>

#include "engine/base/table.h"

namespace oblong {

void PixelOwners::start(std::int32_t width, std::int32_t height) {
    width_px = width;
    height_px = height;
    faces.assign(pixel_count(width, height), kNone);
    seen.clear();
    counts = {};
}

void add_face(ScannedFace face, const ScanlineExtents& rows, std::int32_t width_px,
              std::span<const Vec3<World>> corners, const Vec3<World>& eye, ScannedFaces& scanned) {
    face.first_span = static_cast<std::uint32_t>(scanned.spans.size());
    for (std::int32_t y = rows.first; y < rows.end; ++y) {
        const std::int32_t first = std::max(at(rows.left, y), 0), end = std::min(at(rows.right, y), width_px);
        if (first < end) scanned.spans.push_back({y, first, end});
    }
    face.span_count = static_cast<std::uint32_t>(scanned.spans.size()) - face.first_span;
    face.first_corner = static_cast<std::uint32_t>(scanned.from_eye.size());
    face.corner_count = static_cast<std::uint32_t>(corners.size());
    for (const Vec3<World>& corner : corners) scanned.from_eye.push_back(widening_difference(corner, eye));
    scanned.faces.push_back(face);
}

void append_pixel(std::int32_t face, std::int32_t column, std::int32_t row, std::vector<OwnedRun>& runs) {
    if (!runs.empty() && runs.back().face == face && runs.back().span.y == row && runs.back().span.end == column)
        ++runs.back().span.end;
    else
        runs.push_back({face, {row, column, column + 1}});
}

namespace {

/// Joins runs that continue each other.
void join_runs(std::vector<OwnedRun>& runs) {
    std::size_t count = 0;
    for (const OwnedRun& run : runs) {
        OwnedRun* const last = count > 0 ? &runs[count - 1] : nullptr;
        if (last && last->face == run.face && last->span.y == run.span.y && last->span.end == run.span.first)
            last->span.end = run.span.end;
        else
            runs[count++] = run;
    }
    runs.erase(runs.begin() + static_cast<std::ptrdiff_t>(count), runs.end());
}

}  // namespace

std::vector<OwnedRun> owned_runs(const PixelOwners& owners) {
    std::vector<OwnedRun> runs;
    for (std::int32_t y = 0; y < owners.height_px; ++y) {
        const std::int32_t* const row = owners.row(y);
        for (std::int32_t column = 0; column < owners.width_px; ++column)
            if (row[column] != PixelOwners::kNone) append_pixel(row[column], column, y, runs);
    }
    runs.insert(runs.end(), owners.seen.begin(), owners.seen.end());
    std::stable_sort(runs.begin(), runs.end(), [](const OwnedRun& a, const OwnedRun& b) { return a.face < b.face; });
    join_runs(runs);
    return runs;
}

}  // namespace oblong
