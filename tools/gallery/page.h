#pragma once

#include <string>
#include <vector>

#include "tools/gallery/row.h"

namespace oblong {

/// A picture of a row for the index page.
struct PagePicture {
    std::string file;     ///< beside the page
    std::string caption;  ///< the value of its first parameter; empty without parameters
};

/// A row as the index page shows it.
struct PageRow {
    const Row& row;
    std::vector<PagePicture> pictures;  ///< the first one has the start values
    std::vector<Figures> figures;       ///< the figures of each picture
};

/// The gallery's index page, which needs no other files than the pictures: each row with its seeds, source file, test,
/// and figures, expected and found.
std::string index_page(const std::vector<PageRow>& rows, const ScreenMode& mode);

}  // namespace oblong
