#include "tools/gallery/rows.h"

#include <gtest/gtest.h>

#include <set>

namespace oblong {
namespace {

TEST(GalleryRows, HaveDifferentIds) {
    std::set<std::string_view> ids;
    for (const Row& row : gallery_rows()) EXPECT_TRUE(ids.insert(row.id).second) << row.id;
}

}  // namespace
}  // namespace oblong
