#include "tools/gallery/rows.h"

namespace oblong {

std::vector<Row> gallery_rows() {
    std::vector<Row> rows;
    for (const auto subject : {aspect_rows})
        for (Row& row : subject()) rows.push_back(std::move(row));
    return rows;
}

}  // namespace oblong
