#include <gtest/gtest.h>

#include "engine/level/level.h"

TEST(Level, StartsEmpty) {
    EXPECT_TRUE(oblong::Level{}.faces.empty());
}
