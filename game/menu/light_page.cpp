// The page on which the player sets the light with a test picture: the right value depends on the display and the room.
#include "game/menu/menu_pages.h"
#include "game/options/preference_table.h"

namespace oblong {
namespace {

constexpr std::int32_t kWidth_px = 64, kHeight_px = 48, kSteps = 16, kMarks = 4;

// Sixteen greys from black to white above; below, on black, four squares: the first ones are as dark as a level's dark
// corners.
Rgb8 colour_at(std::int32_t x, std::int32_t y) {
    const auto grey = [](std::int32_t value) {
        const auto channel = static_cast<std::uint8_t>(value);
        return Rgb8{channel, channel, channel};
    };
    if (y < kHeight_px / 2) return grey(x * kSteps / kWidth_px * 255 / (kSteps - 1));
    constexpr std::int32_t kCell_px = kWidth_px / kMarks;
    const std::int32_t mark = x / kCell_px, right = x % kCell_px, down = y - kHeight_px / 2;
    const bool is_inside = right >= 4 && right < kCell_px - 4 && down >= 8 && down < 16;
    return is_inside ? grey(8 << mark) : grey(0);
}

MenuPicture test_picture() {
    auto pixels = std::make_shared<std::vector<Rgb8>>();
    for (std::int32_t y = 0; y < kHeight_px; ++y)
        for (std::int32_t x = 0; x < kWidth_px; ++x) pixels->push_back(colour_at(x, y));
    return {kWidth_px, kHeight_px, pixels};
}

}  // namespace

void MenuPages::open_light() {
    menu_.open([this] {
        MenuPage page{"Light",
                      "Change gamma until you see three of the four squares clearly and the first one barely."};
        for (const char* name : {"gamma", "brightness", "tube-light"}) {
            page.rows.push_back(preference_row(preference_named(name)));
            page.rows.back().picture = test_picture();
        }
        return page;
    });
}

}  // namespace oblong
