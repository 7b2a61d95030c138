// Sprites against the rectangle that they should cover, in doubles.
#include "engine/effects/sprites.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "tests/support/views.h"

namespace oblong::test::sprites_test {

namespace {

/// 64x32 texels: each is its column + 1 at level 0, all of one colour at the others (201, 202, 203).
MipTexture numbered_texture() {
    MipTexture texture{"{numbered", 64, 32, {}, false};
    for (int mip = 0; mip < 4; ++mip)
        texture.mips[as_size(mip)].assign(as_size(64 >> mip) * (32u >> mip), static_cast<std::uint8_t>(200 + mip));
    for (std::size_t i = 0; i < texture.mips[0].size(); ++i) texture.mips[0][i] = static_cast<std::uint8_t>(i % 64 + 1);
    return texture;
}

std::vector<std::uint8_t> same_colours() {
    std::vector<std::uint8_t> row(256);
    for (std::size_t i = 0; i < 256; ++i) row[i] = static_cast<std::uint8_t>(i);
    return row;
}

Sprite sprite_at(Vec3<World> position, std::int32_t scale = 1) {
    return {position, TextureIndex(0), World::from_int(scale)};
}

/// A picture of 320x200 whose background is infinitely far.
struct Picture {
    explicit Picture(const ScreenSprite& sprite) {
        depth.want({0, 320, 0, 200});
        depth.clear();
        draw(sprite);
    }
    void draw(const ScreenSprite& sprite) {
        draw_sprite(sprite, same_colours().data(), depth, {pixels.data(), 320, 200, 320});
    }
    std::uint8_t at(std::int32_t x, std::int32_t y) const { return pixels[as_size(y * 320 + x)]; }

    DepthBuffer depth{320, 200};
    std::vector<std::uint8_t> pixels = std::vector<std::uint8_t>(320 * 200);
};

}  // namespace

TEST(Sprites, CoverTheRectangleOfTheProjection) {
    const MipTexture texture = numbered_texture();
    const auto sprite = project_sprite(sprite_at(point_at(80, 16, 10)), texture, view_from({}));
    ASSERT_TRUE(sprite);
    // 64 units wide and 32 high at a depth of 80: 2 pixels a unit across, and 1/1.2 of that down.
    const double left = 160 - 32 - 64, right = left + 128, top = 100 - 2 / 1.2 * 26, bottom = 100 + 2 / 1.2 * 6;
    const Picture picture(*sprite);
    for (std::int32_t y = 0; y < 200; ++y)
        for (std::int32_t x = 0; x < 320; ++x) {
            const bool is_covered = x + 0.5 >= left && x + 0.5 < right && y + 0.5 >= top && y + 0.5 < bottom;
            ASSERT_EQ(picture.at(x, y), is_covered ? (x - 64) / 2 + 1 : 0) << x << ", " << y;
        }
}

TEST(Sprites, AreClippedAtTheScreensBorders) {
    const MipTexture texture = numbered_texture();
    const auto sprite = project_sprite(sprite_at(point_at(20, 30, 12)), texture, view_from({}));
    ASSERT_TRUE(sprite);
    EXPECT_EQ(sprite->pixels.first_column, 0);
    EXPECT_EQ(sprite->pixels.first_row, 0);
    // 8 pixels a unit, the middle 80 pixels to the left of the screen: column 0 is at texel 32 + 10 of 64.
    EXPECT_EQ(Picture(*sprite).at(0, 50), 42 + 1);
}

TEST(Sprites, AreNotDrawnBehindNearOrBeside) {
    const MipTexture texture = numbered_texture();
    const ViewContext view = view_from({});
    for (const Vec3<World>& at :
         {point_at(-80, 0, 0), point_at(0, 0, 0), point_at(3, 0, 0), point_at(80, 200, 0), point_at(80, 0, 200)})
        EXPECT_FALSE(project_sprite(sprite_at(at), texture, view)) << number_of(at.x);
    EXPECT_TRUE(project_sprite(sprite_at(point_at(4, 0, 0)), texture, view));
}

TEST(Sprites, HideBehindNearerThingsOnly) {
    const MipTexture texture = numbered_texture();
    const ViewContext view = view_from({});
    const auto far_one = project_sprite(sprite_at(point_at(80, 0, 0)), texture, view);
    const auto near_one = project_sprite(sprite_at(point_at(60, 50, 0)), texture, view);
    ASSERT_TRUE(far_one && near_one);
    Picture far_first(*far_one), near_first(*near_one);
    far_first.draw(*near_one);
    near_first.draw(*far_one);
    EXPECT_EQ(far_first.pixels, near_first.pixels);
    const std::int32_t overlap = near_one->pixels.end_column - 1;
    ASSERT_GT(overlap, far_one->pixels.first_column);
    EXPECT_EQ(near_first.at(overlap, 100), 64) << "the last texel of the near one";
}

TEST(Sprites, ShowWhatIsBehindTheirTransparentTexels) {
    MipTexture texture = numbered_texture();
    for (std::size_t i = 0; i < texture.mips[0].size(); i += 2) texture.mips[0][i] = 255;
    const auto sprite = project_sprite(sprite_at(point_at(80, 0, 0)), texture, view_from({}));
    ASSERT_TRUE(sprite);
    Picture picture(*sprite);
    for (std::int32_t x = 100; x < 200; ++x)
        EXPECT_EQ(picture.at(x, 100), (x - 96) / 2 % 2 == 0 ? 0 : (x - 96) / 2 + 1);
    EXPECT_EQ(picture.depth.row(100)[100], 0u) << "nor do they hide anything";
}

TEST(Sprites, UseSmallerTexturesFarAway) {
    const MipTexture texture = numbered_texture();
    const auto colour_at = [&](std::int32_t z) {
        const auto sprite = project_sprite(sprite_at(point_at(z, 0, 0)), texture, view_from({}));
        return sprite ? Picture(*sprite).at(160, 100) : std::uint8_t{0};
    };
    // 1.2 z / 160 texels a pixel, down.
    EXPECT_EQ(colour_at(260), 33);
    EXPECT_EQ(colour_at(270), 201);
    EXPECT_EQ(colour_at(540), 202);
    EXPECT_EQ(colour_at(1080), 203);
}

TEST(Sprites, StandUprightHoweverTheViewIsTurned) {
    // The depth of each row is that of the vertical plane through the middle that faces the eye.
    const MipTexture texture = numbered_texture();
    for (const int degrees : {-30, -10, 20, 40}) {
        const double pitch = degrees * M_PI / 180;
        const ViewContext view = view_from({}, {}, degrees_to_angle(Degrees::from_int(degrees)));
        const auto sprite = project_sprite(sprite_at(point_at(100, 0, -20)), texture, view);
        ASSERT_TRUE(sprite);
        Picture picture(*sprite);
        for (std::int32_t y = sprite->pixels.first_row; y < sprite->pixels.end_row; ++y) {
            const double up = (100 - y - 0.5) / (160 / 1.2);
            // The ray forward + up * up_axis reaches x = 100 at z = 100 / (cos + up * sin).
            const double z = 100 / (std::cos(pitch) + up * std::sin(pitch));
            EXPECT_NEAR(picture.depth.row(y)[160], 0x1p32 / z, 0x1p32 / z * 1e-3) << degrees << ", row " << y;
        }
        const auto row_of = [&](double height) {
            const double forward = 100 * std::cos(pitch) - height * std::sin(pitch);
            const double row = 100 - 160 / 1.2 * (100 * std::sin(pitch) + height * std::cos(pitch)) / forward;
            return std::clamp(row, 0., 200.);
        };
        EXPECT_NEAR(sprite->pixels.first_row, row_of(-20 + 16), 0.6);
        EXPECT_NEAR(sprite->pixels.end_row, row_of(-20 - 16), 0.6);
    }
}

TEST(Sprites, OfAnySizeAndPlaceReadTheirOwnTexelsOnly) {
    const MipTexture texture = numbered_texture();
    std::mt19937 random(1);
    const auto any = [&random](std::int32_t most) {
        return static_cast<std::int32_t>(random() % static_cast<unsigned>(2 * most)) - most;
    };
    int drawn = 0;
    for (int trial = 0; trial < 40000; ++trial) {
        const std::int32_t reach = 1 << (10 + random() % 18);
        Sprite sprite{{World::from_raw(any(reach)), World::from_raw(any(reach)), World::from_raw(any(reach))}, {}, {}};
        sprite.scale = World::from_raw(1 + static_cast<std::int32_t>(random() % 65536));
        const ViewContext view = view_from({}, Angle::from_bam(random()), Angle::from_bam(random()));
        const auto screen = project_sprite(sprite, texture, view);
        if (!screen) continue;
        ++drawn;
        const std::int32_t columns = screen->pixels.end_column - screen->pixels.first_column,
                           rows = screen->pixels.end_row - screen->pixels.first_row;
        const std::int64_t last_u = screen->u_16 + screen->u_step_16 * (columns - 1);
        const std::int64_t last_v = screen->v_16 + screen->v_step_16 * (rows - 1);
        ASSERT_TRUE(screen->u_16 >= 0 && last_u >> 16 < screen->stride);
        ASSERT_TRUE(screen->v_16 >= 0 && last_v >> 16 < screen->stride / 2);
        ASSERT_TRUE(screen->pixels.end_column <= 320 && screen->pixels.end_row <= 200);
        const std::int64_t last_depth_16 = screen->inverse_depth_16 + screen->inverse_depth_step_16 * (rows - 1);
        ASSERT_TRUE(screen->inverse_depth_16 >= 0 && last_depth_16 >= 0);
        ASSERT_LE(std::max(screen->inverse_depth_16, last_depth_16) >> 16, 1ll << 30) << "nearer than 4 units";
    }
    EXPECT_GT(drawn, 1000);
}

}  // namespace oblong::test::sprites_test
