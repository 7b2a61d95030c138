#pragma once

#include <cmath>
#include <vector>

#include "engine/methods/pixel_owners.h"

namespace oblong::test {

inline constexpr std::int32_t kWidth = 16, kHeight = 8;

inline View view_of(double z) {
    return View::from_raw(std::llround(std::ldexp(z, View::kFractionBits)));
}
inline InverseZ inverse_of(double z) {
    return InverseZ::from_raw(std::llround(std::ldexp(1 / z, InverseZ::kFractionBits)));
}

/// Faces that cover parts of a small screen.
struct ScannedScene {
    ScannedFaces scanned;

    /// Columns of each row from `first_row` on; z at the screen's first and last column.
    void add_shape(int face, std::int32_t first_row, std::span<const PixelRange> columns, double first_z, double last_z,
                   bool is_seen_through = false) {
        ScannedFace made;
        made.face = FaceIndex(face);
        made.nearest_z = view_of(std::min(first_z, last_z));
        made.farthest_z = view_of(std::max(first_z, last_z));
        made.is_seen_through = is_seen_through;
        made.inverse_z.origin = inverse_of(first_z);
        made.inverse_z.per_column = InverseZ::from_raw((inverse_of(last_z) - inverse_of(first_z)).raw / (kWidth - 1));
        ScanlineExtents rows(kHeight);
        rows.first = first_row;
        rows.end = first_row + static_cast<std::int32_t>(columns.size());
        for (std::int32_t y = rows.first; y < rows.end; ++y) {
            item(rows.left, y) = item(columns, y - first_row).first;
            item(rows.right, y) = item(columns, y - first_row).end;
        }
        add_face(made, rows, kWidth, {}, {}, scanned);
    }
    void add(int face, const ScreenRectangle& pixels, double first_z, double last_z, bool is_seen_through = false) {
        const std::vector<PixelRange> columns(static_cast<std::size_t>(pixels.end_row - pixels.first_row),
                                              {pixels.first_column, pixels.end_column});
        add_shape(face, pixels.first_row, columns, first_z, last_z, is_seen_through);
    }
    std::size_t size() const { return scanned.faces.size(); }
};

inline PixelOwners no_owners() {
    PixelOwners owners;
    owners.start(kWidth, kHeight);
    return owners;
}

/// A row as text: the number of each pixel's owner, '.' where there is none.
inline std::string text_of_row(const PixelOwners& owners, std::int32_t y) {
    std::string text;
    for (std::int32_t x = 0; x < owners.width_px; ++x)
        text += owners.row(y)[x] < 0 ? '.' : static_cast<char>('0' + owners.row(y)[x]);
    return text;
}

}  // namespace oblong::test
