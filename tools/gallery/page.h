#pragma once

#include <string>
#include <vector>

#include "tools/gallery/row.h"

namespace oblong {

/// A picture of a row for the index page.
struct PagePicture {
    std::string file;     ///< beside the page
    std::string caption;  ///< the value that its first parameter has; empty without parameters
};

/// A row as the index page shows it.
struct PageRow {
    const Row& row;
    std::vector<PagePicture> pictures;  ///< the first is with the values that parameters start with
    std::vector<Figures> figures;       ///< what the row said for each of them
};

/// The gallery's index page, which needs no other file but the pictures: each row with its seeds, source file, test,
/// and figures, expected and found.
std::string index_page(const std::vector<PageRow>& rows, const ScreenMode& mode);

}  // namespace oblong
