#include <array>
#include <cmath>

#include "engine/base/table.h"
#include "tools/demo_level/models/models.h"
#include "tools/demo_level/models/turned.h"

namespace oblong::model_source {
namespace {

using art::Ramp, art::steps;

/// Metal as it shines round about, in a ramp from `level` on, its rims bright; engraved every so many texels (0: not).
art::Canvas paint_metal(Ramp ramp, int level, int mark_every) {
    art::Canvas canvas(64, 8);
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const double shine = std::sin(kTurn * x / 64) + 0.7 * std::sin(kTurn * 3 * x / 64 + 1);
        const bool is_rim = y == 0 || y == 7,
                   is_mark = mark_every > 0 && x % mark_every == 0 && y > (x % 16 == 0 ? 1 : 3);
        const int brightness = steps(level) + static_cast<int>(std::lround(shine * 300));
        return art::Texel{ramp, is_rim ? brightness + 512 : is_mark ? steps(5) : brightness};
    });
    return canvas;
}

art::Canvas paint_globe() {
    art::Canvas canvas(64, 32);
    canvas.fill(canvas.whole(), {Ramp::Night, steps(6)});
    for (int x = 0; x < 64; x += 8) canvas.line(x, 0, x, 31, {Ramp::Brass, steps(8)});
    for (const int y : {8, 16, 24}) canvas.line(0, y, 63, y, {Ramp::Brass, steps(y == 16 ? 11 : 8)});
    constexpr std::array<std::array<int, 2>, 12> kStars{{{3, 11},
                                                         {5, 20},
                                                         {12, 5},
                                                         {18, 13},
                                                         {21, 28},
                                                         {28, 18},
                                                         {35, 10},
                                                         {37, 21},
                                                         {44, 4},
                                                         {51, 13},
                                                         {54, 27},
                                                         {60, 19}}};
    for (const auto& [x, y] : kStars) canvas.at(x, y) = {Ramp::Ivory, steps(15)};
    return canvas;
}

/// Glass seen against the light: a bright middle, darker towards the rim, and where a window is mirrored in it. Rows go
/// from the middle of one side over the rim to that of the other.
art::Canvas paint_glass(Ramp ramp, int darkest, int brightest) {
    art::Canvas canvas(32, 16);
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const int to_rim = y < 8 ? y : 15 - y;  // 0 to 7
        const bool is_window = x % 32 >= 3 && x % 32 < 9 && to_rim >= 2 && to_rim < 5;
        const int level = steps(brightest) - (steps(brightest) - steps(darkest)) * to_rim / 7;
        return is_window ? art::Texel{Ramp::Ice, steps(7)} : art::Texel{ramp, level};
    });
    return canvas;
}

/// The glass of an exhibit's lens.
art::Canvas paint_coloured_glass(std::size_t exhibit) {
    const Ramp ramp = at(art::kLensRamps, exhibit);
    const int last = art::place_of(ramp).count - 1;
    return paint_glass(ramp, last / 2, last);
}

/// A column of glass for each exhibit.
art::Canvas paint_spectrum() {
    art::Canvas canvas(192, 16);
    for (std::size_t i = 0; i < art::kLensRamps.size(); ++i) {
        const art::Canvas glass = paint_coloured_glass(i);
        canvas.paint({static_cast<int>(i) * 16, 0, 16, 16}, [&](int x, int y) { return glass.at(x, y); });
    }
    return canvas;
}

/// What glows by itself, brightest around its equator.
art::Canvas paint_sun() {
    art::Canvas canvas(64, 32);
    const art::NoiseField field{64, 32, 310};
    canvas.paint(canvas.whole(), [&](int x, int y) {
        return art::Texel{Ramp::Flame, steps(5) + art::fractal_noise(field, x, y, 16) * 2};
    });
    return canvas;
}

std::string materials() {
    std::string text = "# Made by oblong-demo-level.\n";
    for (const art::NamedCanvas& skin : paint_all_skins())
        text += "newmtl " + skin.name + "\nmap_Kd " + skin.name + ".png\n";
    return text;
}

}  // namespace

std::vector<art::NamedCanvas> paint_all_skins() {
    std::vector<art::NamedCanvas> skins{{"bronze", paint_metal(Ramp::Wood, 6, 0)},
                                        {"brass", paint_metal(Ramp::Brass, 9, 4)},
                                        {"silver", paint_metal(Ramp::Grey, 11, 0)},
                                        {"gold", paint_metal(Ramp::Brass, 11, 0)},
                                        {"globe", paint_globe()},
                                        {"glass", paint_glass(Ramp::Ice, 4, 6)},
                                        {"spectrum", paint_spectrum()},
                                        {"sun", paint_sun()}};
    for (std::size_t i = 0; i < art::kLensRamps.size(); ++i)
        skins.push_back({"glass" + std::to_string(i + 1), paint_coloured_glass(i)});
    return skins;
}

std::vector<ModelFile> all_model_files() {
    return {{"models.mtl", materials()},
            {"armillary.obj", armillary_obj()},
            {"lens.obj", lens_obj()},
            {"key_silver.obj", key_obj("silver")},
            {"key_gold.obj", key_obj("gold")},
            {"orrery_sun.obj", orrery_sun_obj()},
            {"orrery_lenses.obj", orrery_lenses_obj()},
            {"orrery_stand.obj", orrery_stand_obj()}};
}

}  // namespace oblong::model_source
