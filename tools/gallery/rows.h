#pragma once

#include <vector>

#include "tools/gallery/row.h"

namespace oblong {

/// All rows, in the order of the seeds.
std::vector<Row> gallery_rows();

// The rows of each subject, a file each in tools/gallery/rows/.
std::vector<Row> aspect_rows();
std::vector<Row> cyclic_overlap_rows();
std::vector<Row> hidden_surface_rows();
std::vector<Row> vector_rows();

}  // namespace oblong
