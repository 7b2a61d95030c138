#include "tools/demo_level/models/armillary.h"

#include <array>
#include <cmath>
#include <numbers>

#include "tools/demo_level/models/obj_draft.h"

namespace oblong::model_source {
namespace {

constexpr double kTurn = 2 * std::numbers::pi;
constexpr double kMiddle = 2.05;  ///< the height of the globe's middle
constexpr double kTilt = 23.4 / 360 * kTurn;

/// A place in the rings' own axes, whose y is the axis of the world: tilted, and lifted onto the foot.
ModelPoint placed(const ModelPoint& p, double tilt) {
    const double sine = std::sin(tilt), cosine = std::cos(tilt);
    return {p.x * cosine - p.y * sine, p.x * sine + p.y * cosine + kMiddle, p.z};
}

/// How wide a turned body is at a height.
struct ProfilePoint {
    double radius, y;
};

/// A profile, from the bottom up, turned about the y axis.
std::vector<std::vector<ModelPoint>> turned(const std::vector<ProfilePoint>& profile, int sides) {
    std::vector<std::vector<ModelPoint>> rows;
    for (const ProfilePoint& p : profile) {
        auto& row = rows.emplace_back();
        for (int i = 0; i < sides; ++i) {
            const double angle = -kTurn * i / sides;
            row.push_back({p.radius * std::cos(angle), p.y, p.radius * std::sin(angle)});
        }
    }
    return rows;
}

/// A ring's shape: a band between two radii, so high.
struct Band {
    double inner, outer, height;
};

/// A ring about the y axis and then turned by `place`; each of its four sides is smooth in itself.
template <class Place>
void add_ring(ObjDraft& draft, const Band& band, Place place) {
    constexpr int kSides = 20;
    const double low = -band.height / 2, high = band.height / 2;
    const std::array<ProfilePoint, 5> outline{
        {{band.outer, low}, {band.outer, high}, {band.inner, high}, {band.inner, low}, {band.outer, low}}};
    for (std::size_t side = 0; side < 4; ++side) {
        draft.begin_smooth_part();
        auto rows = turned({outline[side], outline[side + 1]}, kSides);
        for (auto& row : rows)
            for (ModelPoint& point : row) point = place(point);
        draft.add_closed_grid(rows);
    }
}

void add_foot(ObjDraft& draft) {
    const std::vector<std::vector<ProfilePoint>> parts = {
        {{0.62, 0}, {0.62, 0.07}},
        {{0.62, 0.07}, {0.6, 0.12}, {0.5, 0.15}, {0.3, 0.18}, {0.17, 0.25}, {0.13, 0.34}},
        {{0.13, 0.34}, {0.19, 0.36}, {0.19, 0.4}, {0.12, 0.42}},
        {{0.12, 0.42}, {0.2, 0.52}, {0.22, 0.6}, {0.18, 0.7}, {0.1, 0.8}, {0.09, 0.9}},
        {{0.09, 0.9}, {0.2, 0.95}, {0.24, 1}, {0.22, 1.04}, {0.02, 1.07}},
    };
    for (const auto& part : parts) {
        draft.begin_smooth_part();
        draft.add_closed_grid(turned(part, 12));
    }
}

void add_globe(ObjDraft& draft) {
    constexpr int kRows = 8;
    std::vector<ProfilePoint> profile;
    for (int i = 0; i <= kRows; ++i) {
        const double latitude = kTurn * (i - kRows / 2) / (2 * kRows);
        profile.push_back({0.42 * std::cos(latitude), 0.42 * std::sin(latitude)});
    }
    auto rows = turned(profile, 14);
    for (auto& row : rows)
        for (ModelPoint& point : row) point = placed(point, kTilt);
    draft.begin_smooth_part();
    draft.add_closed_grid(rows);
}

void add_axis(ObjDraft& draft) {
    auto rows = turned({{0.025, -0.92}, {0.025, 0.92}}, 6);
    for (auto& row : rows)
        for (ModelPoint& point : row) point = placed(point, kTilt);
    draft.begin_smooth_part();
    draft.add_closed_grid(rows);
}

/// Metal as it shines round about, in a ramp from `level` on, its rims bright; engraved every so many texels (0: not).
art::Canvas paint_metal(art::Ramp ramp, int level, int mark_every) {
    art::Canvas canvas(64, 8);
    canvas.paint(canvas.whole(), [&](int x, int y) {
        const double shine = std::sin(kTurn * x / 64) + 0.7 * std::sin(kTurn * 3 * x / 64 + 1);
        const bool is_rim = y == 0 || y == 7,
                   is_mark = mark_every > 0 && x % mark_every == 0 && y > (x % 16 == 0 ? 1 : 3);
        const int brightness = art::steps(level) + static_cast<int>(std::lround(shine * 300));
        return art::Texel{ramp, is_rim ? brightness + 512 : is_mark ? art::steps(5) : brightness};
    });
    return canvas;
}

art::Canvas paint_globe() {
    using art::Ramp, art::steps;
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

}  // namespace

std::string armillary_obj() {
    ObjDraft draft("armillary.mtl");
    draft.use_material("bronze");
    add_foot(draft);
    draft.use_material("brass");
    add_ring(draft, {0.93, 1, 0.09}, [](const ModelPoint& p) { return placed({p.x, p.z, -p.y}, 0); });
    add_ring(draft, {0.86, 0.92, 0.09}, [](const ModelPoint& p) { return placed(p, kTilt); });
    add_ring(draft, {0.78, 0.85, 0.2}, [](const ModelPoint& p) { return placed(p, -kTilt / 2); });
    add_axis(draft);
    draft.use_material("globe");
    add_globe(draft);
    return draft.text();
}

std::string armillary_mtl() {
    std::string text = "# Made by oblong-demo-level.\n";
    for (const std::string name : {"bronze", "brass", "globe"})
        text += "newmtl " + name + "\nmap_Kd " + name + ".png\n";
    return text;
}

std::vector<art::NamedCanvas> paint_armillary() {
    return {{"bronze", paint_metal(art::Ramp::Wood, 6, 0)},
            {"brass", paint_metal(art::Ramp::Brass, 9, 4)},
            {"globe", paint_globe()}};
}

}  // namespace oblong::model_source
