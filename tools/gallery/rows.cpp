#include "tools/gallery/rows.h"

#include <algorithm>

namespace oblong {

std::vector<Row> gallery_rows() {
    std::vector<Row> rows;
    for (const auto subject :
         {aspect_rows, clipping_rows, culling_rows, cyclic_overlap_rows, hidden_surface_rows, inspection_rows,
          line_clipping_rows, line_rows, mesh_rows, projection_matrix_rows, projection_rows, shading_rows, stage_rows,
          texture_rows, transform_rows, triangle_rows, vector_rows, view_rows})
        for (Row& row : subject()) rows.push_back(std::move(row));
    const auto first_seed = [](const Row& row) { return row.seeds.front(); };
    std::stable_sort(rows.begin(), rows.end(),
                     [&](const Row& a, const Row& b) { return first_seed(a) < first_seed(b); });
    return rows;
}

}  // namespace oblong
