#include "engine/scene/texture_animation.h"

#include <gtest/gtest.h>

#include "tests/scene/scene_fixture.h"

namespace oblong::test {
namespace {

struct Animated {
    Level level = tiny_level();
    std::vector<std::string> warnings;
    TextureAnimations animations;

    explicit Animated(const std::vector<std::string>& names) {
        for (const std::string& name : names) add_texture(level, name);
        animations = TextureAnimations(level, warnings);
    }

    std::string shown(const std::string& name, std::int64_t time_ms, bool is_switched = false) const {
        for (const TextureIndex texture : level.textures.indices())
            if (level.textures[texture].name == name)
                return level.textures[animations.shown(texture, is_switched, time_ms)].name;
        return "no such texture";
    }
};

TEST(TextureAnimation, AllOfASequenceShowTheSameFrameFiveTimesASecond) {
    const Animated scene({"+1fire", "plain", "+0fire", "+2fire"});
    EXPECT_TRUE(scene.warnings.empty());
    for (const std::int64_t start : {std::int64_t{0}, std::int64_t{1} << 32, std::int64_t{1} << 60})
        for (std::int64_t time = start; time < start + 1500; time += 37) {
            const std::string frame = "+" + std::to_string(time / 200 % 3) + "fire";
            for (const char* name : {"+0fire", "+1fire", "+2fire"}) ASSERT_EQ(scene.shown(name, time), frame) << time;
            ASSERT_EQ(scene.shown("plain", time), "plain");
        }
}

TEST(TextureAnimation, SwitchedModelsShowTheLetters) {
    const Animated scene({"+0button", "+aButton", "+abutton", "+bbutton", "+1button", "+Cbutton"});
    for (const std::int64_t time : {0, 199, 200, 400, 600, 1000}) {
        const std::string digits = "+" + std::to_string(time / 200 % 2) + "button";
        const std::string letters = std::string("+") + "abC"[time / 200 % 3] + "button";
        EXPECT_EQ(scene.shown("+0button", time), digits);
        EXPECT_EQ(scene.shown("+1button", time, true), letters);
        EXPECT_EQ(scene.shown("+bbutton", time), letters) << "a face that names a letter begins with the letters";
        EXPECT_EQ(scene.shown("+Cbutton", time, true), digits);
        EXPECT_EQ(scene.shown("+aButton", time, true), "+aButton") << "another name";
    }
}

TEST(TextureAnimation, HaveTenFramesOfEachKind) {
    std::vector<std::string> names;
    for (const char frame : std::string("0123456789abcdefghIJ")) names.push_back(std::string{'+', frame} + "lamp");
    const Animated scene(names);
    EXPECT_TRUE(scene.warnings.empty());
    for (std::size_t i = 0; i < 20; ++i)
        EXPECT_EQ(scene.shown(i < 10 ? "+9lamp" : "+alamp", static_cast<std::int64_t>(i % 10 * 200)), names[i]);
    names[19] = "+jlamp";
    EXPECT_EQ(Animated(names).shown("+alamp", 1800), "+jlamp");
    for (const char* wrong : {"+klamp", "+Klamp", "+:lamp", "+/lamp", "+@lamp", "+`lamp"})
        EXPECT_EQ(Animated({wrong}).warnings.size(), 1u) << wrong;
}

TEST(TextureAnimation, OneFrameStandsStillUnlessSwitched) {
    const Animated alone({"+0alone"}), pair({"+0pair", "+apair"}), letters({"+aletters", "+bletters"});
    EXPECT_TRUE(alone.animations.is_empty());
    EXPECT_EQ(pair.shown("+0pair", 200), "+0pair");
    EXPECT_EQ(pair.shown("+0pair", 0, true), "+apair");
    EXPECT_EQ(letters.shown("+aletters", 200), "+bletters");
    EXPECT_EQ(letters.shown("+aletters", 200, true), "+bletters") << "there are no others";
}

TEST(TextureAnimation, ALevelWithoutSequencesHasNone) {
    const Animated scene({"plus", "a+0", "+"});
    EXPECT_TRUE(scene.animations.is_empty());
    EXPECT_TRUE(scene.warnings.empty());
    EXPECT_EQ(scene.shown("plus", 1000, true), "plus");
}

void expect_still(Animated scene, const std::string& warning) {
    ASSERT_EQ(scene.warnings.size(), 1u) << warning;
    EXPECT_EQ(scene.warnings[0], warning);
    EXPECT_TRUE(scene.animations.is_empty());
    EXPECT_EQ(scene.shown("+0x", 200), "+0x");
    EXPECT_EQ(scene.shown("+0x", 0, true), "+0x");
}

TEST(TextureAnimation, BrokenSequencesAreReportedAndStandStill) {
    expect_still(Animated({"+0x", "+3x"}),
                 "animated texture 'x': frame '+1x' is missing, expected no gap; it stands still");
    expect_still(Animated({"+0x", "+1x", "+bx"}),
                 "animated texture 'x': frame '+ax' is missing, expected no gap; it stands still");
    expect_still(Animated({"+0x", "+1x", "+1x"}),
                 "animated texture 'x': '+1x' is there twice, expected once; it stands still");
    expect_still(Animated({"+0x", "+kx"}), "texture '+kx': expected a frame 0 to 9 or a to j behind the +");
}

TEST(TextureAnimation, FramesOfOtherSizesAreReportedAndStandStill) {
    Animated scene({"+0x", "+ax"});
    add_texture(scene.level, "+1x", 7, 32);
    scene.animations = TextureAnimations(scene.level, scene.warnings);
    expect_still(std::move(scene),
                 "animated texture 'x': '+1x' and '+0x' differ in size, expected frames of one size; it stands still");
}

TEST(TextureAnimation, ABrokenSequenceLeavesOthersAlone) {
    const Animated scene({"+0x", "+2x", "+0y", "+1y"});
    EXPECT_EQ(scene.shown("+0y", 200), "+1y");
    EXPECT_EQ(scene.shown("+0x", 200), "+0x");
}

}  // namespace
}  // namespace oblong::test
