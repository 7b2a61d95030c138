#include "game/view/hud.h"

#include <gtest/gtest.h>

#include <random>

#include "engine/draw/text.h"

namespace oblong {
namespace {

std::string random_text(std::mt19937& random, int longest) {
    std::string text(1 + random() % static_cast<unsigned>(longest), 'm');
    for (char& letter : text)
        if (random() % 6 == 0) letter = random() % 8 == 0 ? '\n' : ' ';
    return text;
}

std::vector<std::string> random_texts(std::mt19937& random, unsigned most, int longest) {
    std::vector<std::string> texts(random() % (most + 1));
    for (std::string& text : texts) text = random_text(random, longest);
    return texts;
}

// No two parts share a row, and all are in the canvas.
TEST(Hud, NothingOverlaps) {
    std::mt19937 random(4);
    std::vector<std::uint8_t> pixels(640 * 480);
    CostText cost;
    cost.frame = "99999 us a frame, 999 frames a second, 12 movers";
    cost.passes.resize(8), cost.effects.resize(6);
    for (int i = 0; i < 20'000 && !testing::Test::HasFailure(); ++i) {
        const bool is_small = random() % 2 == 0;
        const Framebuffer canvas{pixels.data(), is_small ? 320 : 640, is_small ? 200 : 480, 640};
        const HudText text{random_texts(random, 3, 60), random_texts(random, 2, 200),
                           random() % 3 == 0 ? &cost : nullptr};
        const TextColours colours{255, 0, 1 + static_cast<std::int32_t>(random() % 2)};
        const bool has_messages = random() % 2 == 0;
        const auto bottom = static_cast<std::int32_t>(random() % 201);
        const HudLayout layout = lay_out_hud(text, has_messages, bottom, colours, canvas);
        std::vector<int> owners(480);
        std::vector<RowRange> parts = layout.notes;
        parts.insert(parts.end(), {layout.captions, layout.cost, layout.messages});
        for (const RowRange& part : parts)
            for (std::int32_t row = part.top; row < part.bottom; ++row) {
                ASSERT_GE(row, 0);
                ASSERT_LT(row, canvas.height_px);
                EXPECT_EQ(++owners[static_cast<std::size_t>(row)], 1) << row << " in run " << i;
            }
    }
}

TEST(Hud, AMessageComesFirstThenCaptionsNotesAndCost) {
    std::vector<std::uint8_t> pixels(320 * 200);
    const Framebuffer canvas{pixels.data(), 320, 200, 320};
    const TextColours colours{255, 0, 1};
    CostText cost;
    cost.frame = "1 us a frame";
    const HudText text{{"[door]"}, {"a wall"}, &cost};
    const HudLayout roomy = lay_out_hud(text, true, 200, colours, canvas);
    EXPECT_EQ(roomy.captions.bottom, 200);
    EXPECT_EQ(roomy.notes[0].bottom, roomy.captions.top);
    EXPECT_EQ(roomy.cost.bottom, roomy.notes[0].top);
    EXPECT_EQ(roomy.messages.bottom, roomy.cost.top);
    const HudLayout narrow = lay_out_hud(text, true, 24, colours, canvas);
    EXPECT_GE(narrow.messages.height(), kLineHeight_px);
    EXPECT_EQ(narrow.captions.height(), kLineHeight_px);
    EXPECT_EQ(narrow.notes[0].height() + narrow.cost.height(), 0);
}

}  // namespace
}  // namespace oblong
