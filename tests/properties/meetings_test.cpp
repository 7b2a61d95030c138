// Random rooms in which fences, liquids, models, sprites, particles, fog, shadows, mirrors and brush models meet. Each
// frame is the same bytes in a used workspace that counts and records as in a fresh one that does neither, and each
// pixel has a colour that rays in doubles, through the boxes of which the room was made, allow.
//     RC_PARAMS=max_success=2500 build/bin/test_properties --gtest_filter='PropertyMeetings.*'    # 10,000 frames

#include <gtest/gtest.h>
#include <rapidcheck/gtest.h>

#include <bitset>

#include "engine/accuracy/accuracy.h"
#include "engine/effects/colour_tables.h"
#include "tests/effect_frames/effect_stage.h"
#include "tools/gallery/mesh_scene.h"

namespace oblong::test {
namespace {

constexpr std::uint8_t kBall = 220;  // no texture's
constexpr double kBallRadius = 24;

using Colours = std::bitset<256>;

struct RoomBox {
    std::string texture;
    bool is_model = false;
    Whole mins{}, maxs{};
};

struct Meeting {
    std::vector<RoomBox> boxes;
    std::vector<Whole> balls, sprites, sparks;
    bool has_fog = false, has_sky = false;
    std::array<int, 5> eye{};  ///< x, y, z, and degrees of yaw and pitch
};

Whole any_place() {
    return {*rc::gen::inRange(-15, 15) * 16, *rc::gen::inRange(-15, 15) * 16, *rc::gen::inRange(1, 10) * 16};
}

RoomBox any_box() {
    const std::string texture =
        *rc::gen::element<std::string>("other", "{bars", "{bars", "*slime", "*slime", "*lava", "mirror", "+0sign");
    RoomBox box{texture, texture != "other" || *rc::gen::inRange(0, 2) == 1, any_place(), {}};
    for (std::size_t axis = 0; axis < 3; ++axis) box.maxs[axis] = box.mins[axis] + *rc::gen::inRange(1, 12) * 8;
    box.maxs[2] = std::min(box.maxs[2], 190);
    return box;
}

std::vector<Whole> any_places(int most) {
    std::vector<Whole> places(static_cast<std::size_t>(*rc::gen::inRange(0, most + 1)));
    for (Whole& at : places) at = any_place();
    return places;
}

Meeting any_meeting() {
    Meeting meeting;
    meeting.boxes.resize(static_cast<std::size_t>(*rc::gen::inRange(1, 12)));
    for (RoomBox& box : meeting.boxes) box = any_box();
    meeting.balls = any_places(3);
    meeting.sprites = any_places(3);
    meeting.sparks = any_places(2);
    meeting.has_fog = *rc::gen::inRange(0, 3) == 0;
    meeting.has_sky = *rc::gen::inRange(0, 3) == 0;
    return meeting;
}

Level compile_meeting(const Meeting& meeting) {
    MapText text;
    text.brushes = room({-256, -256, 0}, {256, 256, 192}, 16, meeting.has_sky ? "sky" : "wall");
    text.entities = entity_at("info_player_start", {-248, -248, 1}) + entity_at("light", {0, 0, 120});
    for (const RoomBox& one : meeting.boxes) {
        const std::string brush = box(one.mins, one.maxs, one.texture);
        (one.is_model ? text.entities : text.brushes) += one.is_model ? entity("func_wall", {}, brush) : brush;
    }
    for (const Whole& at : meeting.sprites)
        text.entities += entity_at("misc_sprite", at, {{"texture", "{lamp"}, {"scale", "2"}, {"shadow", "24"}});
    for (const Whole& at : meeting.sparks) text.entities += entity_at("misc_sparks", at, {{"colour", "130 137"}});
    text.world_keys = {{"slimealpha", "0.5"}};
    if (meeting.has_fog) text.world_keys.push_back({"fog", "0.4 0.5 0.5 0.5"});
    return compile_effects(text);
}

std::vector<PlacedMesh> placed_balls(const Meeting& meeting) {
    static const Mesh mesh = ball_mesh(kBallRadius, 6, plain_skin(kBall));
    std::vector<PlacedMesh> placed;
    for (const Whole& at : meeting.balls) {
        placed.emplace_back();
        placed.back().mesh = &mesh;
        placed.back().position = to_world(place_of(at));
        placed.back().least_light = 256;  // all shades but the shadows' are the colour itself
    }
    return placed;
}

bool is_seen_through(const RoomBox& box) {
    return box.texture == "{bars" || box.texture == "*slime";
}

/// What a ray meets: the opaque box in front, or those that are as near (none: the room), and what is seen through
/// before them, nearest first.
struct Sight {
    std::vector<const RoomBox*> opaque, before;
    bool operator==(const Sight&) const = default;
};

Sight sight_along(const Point& eye, const Point& ray, const Meeting& meeting) {
    constexpr double kAsNear = 1 / 64.0;
    double nearest = passage_of(eye, ray, {-256, -256, 0}, {256, 256, 192}).exit;
    std::vector<std::pair<double, const RoomBox*>> met;
    for (const RoomBox& box : meeting.boxes) {
        const auto [entry, exit] = passage_of(eye, ray, place_of(box.mins), place_of(box.maxs));
        if (entry >= exit || exit <= 0) continue;
        met.push_back({entry, &box});
        if (!is_seen_through(box) && entry > 0) nearest = std::min(nearest, entry);
    }
    std::sort(met.begin(), met.end());
    Sight sight;
    for (const auto& [entry, box] : met)
        if (entry < nearest + kAsNear && (entry > 0 || is_seen_through(*box)))
            (is_seen_through(*box) ? sight.before : sight.opaque).push_back(box);
    return sight;
}

Colours set_of(std::initializer_list<int> colours) {
    Colours set;
    for (const int colour : colours) set.set(static_cast<std::size_t>(colour));
    return set;
}

Colours own_colours(const Sight& sight, const Meeting& meeting) {
    Colours colours;
    for (const RoomBox* box : sight.opaque) {
        if (box->texture == "*lava") colours |= set_of({kLava});
        if (box->texture == "+0sign") colours |= set_of({kSign0, kSign1, kSign2});
        if (box->texture == "other") colours |= set_of({kOther});
    }
    if (colours.none()) colours = meeting.has_sky ? set_of({1, 5}) : set_of({kWall});
    return colours;
}

bool shows_mirror(const Sight& sight) {
    return std::any_of(sight.opaque.begin(), sight.opaque.end(),
                       [](const RoomBox* box) { return box->texture == "mirror"; });
}

/// The set, and what each of its colours may become.
Colours with_each(const Colours& set, auto becomes) {
    Colours all = set;
    for (std::size_t colour = 0; colour < 256; ++colour)
        if (set[colour]) all |= becomes(colour);
    return all;
}

/// The colours of things where a ray passes one, near enough or far enough to stand anywhere among the boxes.
Colours thing_colours(const Point& eye, const Point& ray, const Meeting& meeting) {
    Colours colours;
    const auto passes = [&](const Whole& at, double reach) {
        const Point to{at[0] - eye.x, at[1] - eye.y, at[2] - eye.z};
        const double along = std::max(0.0, dot(to, ray) / dot(ray, ray));
        const Point off = to - ray * along;
        return dot(off, off) < reach * reach;
    };
    for (const Whole& at : meeting.balls)
        if (passes(at, kBallRadius * 1.02 + 4)) colours.set(kBall);
    for (const Whole& at : meeting.sprites)
        if (passes(at, 100)) colours.set(kLamp);
    if (!meeting.sparks.empty())
        for (std::size_t colour = 130; colour <= 137; ++colour) colours.set(colour);
    return colours;
}

Colours allowed_colours(const Sight& sight, const Point& eye, const Point& ray, const Meeting& meeting,
                        const Colormap& colormap) {
    static const BlendTable half = make_blend_table(colormap.palette, 128);
    const Colours things = thing_colours(eye, ray, meeting);
    Colours colours = own_colours(sight, meeting);
    // In a sprite's shadow, twice in its middle, and where light has the shade that shadows have in effect_colours().
    for (std::size_t dark = 0; dark <= 2 * meeting.sprites.size(); ++dark)
        colours = with_each(colours, [](std::size_t colour) { return set_of({static_cast<int>(colour / 2)}); });
    colours |= things;
    // Boxes may stand in each other, so that they are drawn over each other in any order. Each of slime has its front
    // and its back; and where the tree has cut a face, a pixel on the cut may be of both pieces.
    const std::size_t layers = 3 * sight.before.size();
    for (std::size_t layer = 0; layer < layers; ++layer)
        for (const RoomBox* box : sight.before) {
            if (box->texture == "{bars") colours |= set_of({kBars, kBars / 2});
            if (box->texture == "*slime")
                colours = with_each(colours, [](std::size_t colour) {
                    return set_of({half.rows[kSlime][colour], half.rows[colour][kSlime]});
                });
            colours |= things;
        }
    return colours;
}

std::string text_of(const Whole& at) {
    return std::to_string(at[0]) + " " + std::to_string(at[1]) + " " + std::to_string(at[2]);
}

std::string text_of(const Meeting& meeting) {
    std::string text = meeting.has_sky ? "sky" : "walls";
    for (const RoomBox& box : meeting.boxes)
        text +=
            "; " + box.texture + (box.is_model ? " (model) " : " ") + text_of(box.mins) + " to " + text_of(box.maxs);
    for (const Whole& at : meeting.balls) text += "; ball " + text_of(at);
    for (const Whole& at : meeting.sprites) text += "; sprite " + text_of(at);
    for (const Whole& at : meeting.sparks) text += "; sparks " + text_of(at);
    return text;
}

/// Every eleventh pixel, another one in each row.
void expect_allowed_colours(const Picture& picture, const EffectStage& stage, const Meeting& meeting) {
    const TrueCamera camera(stage.camera);
    constexpr double kMargin = 0.1;  // of vertices on the screen
    for (int pixel = 0; pixel < kPicturePixels; pixel += 11) {
        const int column = pixel % kPictureWidth, row = pixel / kPictureWidth;
        const auto sight = at_all_rays(camera, column, row, kMargin,
                                       [&](const Point& ray) { return sight_along(camera.eye, ray, meeting); });
        if (!sight || shows_mirror(*sight)) continue;
        const Point ray = camera.through_pixel(column, row);
        const std::uint8_t colour = picture[static_cast<std::size_t>(pixel)];
        if (!allowed_colours(*sight, camera.eye, ray, meeting, stage.colormap)[colour])
            RC_FAIL("pixel " + std::to_string(column) + ", " + std::to_string(row) + " has colour " +
                    std::to_string(colour) + " before " +
                    (sight->opaque.empty() ? "the room" : sight->opaque.front()->texture) + " and " +
                    std::to_string(sight->before.size()) + " that are seen through; " + text_of(meeting));
    }
}

/// Whether an eye is clear of all boxes, whose insides show no faces.
bool is_in_the_open(const Whole& eye, const Meeting& meeting) {
    return std::none_of(meeting.boxes.begin(), meeting.boxes.end(), [&](const RoomBox& box) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            if (eye[axis] < box.mins[axis] - 1 || eye[axis] > box.maxs[axis] + 1) return false;
        return true;
    });
}

RC_GTEST_PROP(PropertyMeetings, EachPixelHasAColourThatRaysAllow, ()) {
    const Meeting meeting = any_meeting();
    EffectStage stage(compile_meeting(meeting), {}, effect_colours(), placed_balls(meeting));
    for (int frame = 0; frame < 4; ++frame) {
        const Whole eye = {*rc::gen::inRange(-250, 250), *rc::gen::inRange(-250, 250), *rc::gen::inRange(3, 188)};
        stage.camera = camera_at(point_at(eye[0] + 0.3, eye[1] + 0.7, eye[2] + 0.1), *rc::gen::inRange(0, 360),
                                 *rc::gen::inRange(-80, 80));
        const std::int64_t time_ms = *rc::gen::element<std::int64_t>(0, 137, 2'900, std::int64_t{1} << 33);
        stage.settings.accuracy = accuracy_of(*rc::gen::elementOf(kPresets));
        RC_ASSERT(stage.draw(time_ms) == stage.draw_afresh(time_ms));
        // Whole-pixel vertices part the pieces into which the tree cuts brush models: what is behind shows between
        // them.
        if (stage.settings.accuracy.subpixel_bits == 0 || !is_in_the_open(eye, meeting)) continue;
        const Picture clear = stage.draw_without(Effect::Fog, time_ms);
        expect_allowed_colours(clear, stage, meeting);
    }
}

}  // namespace
}  // namespace oblong::test
