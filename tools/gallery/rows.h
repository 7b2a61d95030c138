#pragma once

#include <vector>

#include "tools/gallery/row.h"

namespace oblong {

/// All rows, in the order of the seeds.
std::vector<Row> gallery_rows();

// The rows of each subject, a file each in tools/gallery/rows/.
std::vector<Row> aspect_rows();
std::vector<Row> clipping_rows();
std::vector<Row> culling_rows();
std::vector<Row> cyclic_overlap_rows();
std::vector<Row> hidden_surface_rows();
std::vector<Row> inspection_rows();
std::vector<Row> line_clipping_rows();
std::vector<Row> line_rows();
std::vector<Row> mesh_rows();
std::vector<Row> projection_matrix_rows();
std::vector<Row> projection_rows();
std::vector<Row> shading_rows();
std::vector<Row> stage_rows();
std::vector<Row> texture_rows();
std::vector<Row> transform_rows();
std::vector<Row> triangle_rows();
std::vector<Row> vector_rows();
std::vector<Row> view_rows();

}  // namespace oblong
