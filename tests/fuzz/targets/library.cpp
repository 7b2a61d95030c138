// Programs that use the library: the functions of oblong.h called in any order, with any arguments.

#include <algorithm>
#include <cmath>
#include <map>
#include <memory>
#include <numbers>

#include "engine/frame/frame.h"
#include "engine/io/files.h"
#include "engine/level/level.h"
#include "engine/library/oblong.h"
#include "engine/platform/platform.h"
#include "tests/fuzz/common/library_calls.h"
#include "tests/fuzz/common/plain_drawing.h"
#include "tests/fuzz/common/played_level.h"
#include "tests/map/map_source.h"
#include "tests/support/folders.h"

namespace oblong::fuzz {
namespace {

constexpr ScreenMode kSmall{64, 40, {4, 3}};

// What two scenes or stages show must be the same, whatever was done with the first one before.
template <class Drawn>
struct Twins {
    Drawn used, fresh;
    template <class... Arguments>
    explicit Twins(const Arguments&... with) : used(with...), fresh(with...) {}
    template <class Change>
    void change(Change work) {
        work(used);
        work(fresh);
    }
    template <class Draw>
    void demand_same_picture(Draw draw) {
        Picture first = Picture::of_size(kSmall.width_px, kSmall.height_px), second = first;
        draw(used, first.canvas());
        draw(fresh, second.canvas());
        expect(first.pixels == second.pixels, "the picture of one that nothing else was done with");
    }
};

const std::string& level_file() {
    static const test::TemporaryFolder folder;
    static const std::string file = [] {
        const std::string text =
            read_text(test::source_folder() + "/tests/fuzz/corpus/maps/stage.map") +
            test::entity("func_door_rotating", {{"origin", "-60 0 20"}}, test::box({-64, 0, 8}, {-56, 30, 50})) +
            test::entity_at("misc_model", {-30, 30, 30}, {{"model", "t.obj"}, {"period", "3"}});
        folder.write("t.obj", std::string("v 0 0 0\nv 9 0 0\nv 0 9 0\nvt 0 0\nvt 1 0\nvt 1 1\nf 1/1 2/2 3/3\n"));
        return folder.write("stage.bsp", map::to_bytes(test::compile(text, {true})));
    }();
    return file;
}

// The programs' own models, and how many pictures each takes.
struct OwnModel {
    std::unique_ptr<Model> model = std::make_unique<Model>();
    std::int32_t pictures = 0;
};

class Session : LibraryCalls {
  public:
    explicit Session(Input bytes) : LibraryCalls(bytes) {}

    void run() {
        using Call = void (Session::*)();
        constexpr Call kCalls[] = {&Session::change_picture, &Session::draw,       &Session::draw,
                                   &Session::draw,           &Session::stamp,      &Session::compute,
                                   &Session::use_palette,    &Session::use_window, &Session::use_window,
                                   &Session::use_speaker,    &Session::build,      &Session::build,
                                   &Session::use_stage,      &Session::use_level,  &Session::use_level,
                                   &Session::draw_level,     &Session::walk};
        for (int calls = 0; calls < 200 && are_left(); ++calls) (this->*kCalls[below(std::size(kCalls))])();
    }

  private:
    Picture& picture() { return pictures_[below(pictures_.size())]; }
    OwnModel& model() { return models_[below(models_.size())]; }
    Pose pose() {
        if (below(2)) return pose_at(number() / 2, number() / 2, number() / 2, number(), number(), number());
        return {number(), number(), number(), number(), number(), number()};
    }
    Corner corner() { return {number(), number(), number(), number(), number()}; }
    PixelPosition position() { return {number(), number()}; }

    void change_picture() {
        Picture& changed = picture();
        const std::int32_t width = number(), height = number();
        const std::size_t kind = below(4);
        if (kind == 0) return void(changed.width_px = width);
        if (kind == 1) return changed.pixels.resize(std::min<std::size_t>(byte(), 200));
        if (kind == 2 && width >= 0 && height >= 0 && width < 30 && height < 30)
            changed = {width, height, std::vector<std::uint8_t>(pixel_count(width, height))};
        if (kind == 3 && accepts([&] { changed = Picture::of_size(width, height); })) {
            expect(is_whole(changed) && width > 0 && height > 0, "a picture of one pixel or more");
            if (std::max(width, height) > 100) changed = Picture::of_size(30, 20);
        }
        for (std::uint8_t& pixel : changed.pixels)
            pixel = static_cast<std::uint8_t>(height + 37 * (&pixel - changed.pixels.data()));
    }

    // A canvas to draw in: a whole picture's, or a part of it.
    bool choose(Framebuffer& canvas) {
        Picture& chosen = picture();
        const bool is_taken = accepts([&] { canvas = chosen.canvas(); });
        expect(is_taken == is_whole(chosen), "a canvas of a picture with all of its pixels");
        if (is_taken && canvas.width_px > 4 && canvas.height_px > 4 && below(2))
            canvas = {canvas.row(1) + 2, canvas.width_px - 3, canvas.height_px - 2, canvas.pitch};
        return is_taken;
    }

    void draw();
    void stamp();
    void compute();
    void use_palette();
    void use_window();
    void use_speaker();
    void build();
    void use_stage();
    void use_level();
    void draw_level();
    void walk();
    Twins<LevelScene>& scenes();
    template <class Scene>
    void show_models(Scene show);

    std::array<Picture, 4> pictures_{Picture{}, Picture::of_size(24, 16), Picture{5, 0, {}}, Picture::of_size(7, 9)};
    std::array<OwnModel, 3> models_;
    Palette palette_ = greys();
    FedWindow window_;
    std::map<std::int32_t, std::array<std::int32_t, 3>> moved_;
    std::map<std::int32_t, std::int32_t> turned_;
    std::map<std::int32_t, bool> hidden_;
    bool has_scenes_ = false;
};

void Session::draw() {
    Framebuffer canvas;
    if (!choose(canvas)) return;
    const PixelPosition at = position(), second = position(), third = position();
    const std::int32_t colour = number(), index = colour & 255;
    const std::int32_t x = at.column, y = at.row, width = second.column, height = second.row;
    const auto check = [&](auto work, auto is_drawn) {
        check_drawn(canvas, work, [&](PixelPosition pixel) { return is_drawn(pixel) ? index : kNone; });
    };
    const PlainRectangle area{x, y, width, height};
    constexpr ScreenMode kModes[] = {{320, 200, {4, 3}}, {640, 200, {4, 3}}, {8, 4096, {100, 1}}};
    const ScreenMode& mode = kModes[below(std::size(kModes))];
    const std::int32_t radius = std::clamp(width, 0, 8192);
    const auto is_inside = [&](PixelPosition pixel) { return is_in_circle(mode, at, radius, pixel); };
    const std::size_t kind = below(10);
    if (kind == 0) check([&] { clear(canvas, colour); }, [](PixelPosition) { return true; });
    if (kind == 1) check([&] { set_pixel(canvas, x, y, colour); }, [&](PixelPosition pixel) { return pixel == at; });
    if (kind == 2)
        check([&] { draw_line(canvas, x, y, width, height, colour); },
              [&](PixelPosition pixel) { return is_on_line(at, second, pixel); });
    if (kind == 3)
        check([&] { fill_rectangle(canvas, x, y, width, height, colour); },
              [&](PixelPosition pixel) { return area.has(pixel.column, pixel.row); });
    if (kind == 4)
        check([&] { draw_rectangle(canvas, x, y, width, height, colour); },
              [&](PixelPosition pixel) { return area.has_on_border(pixel.column, pixel.row); });
    if (kind == 5) check([&] { fill_circle(canvas, mode, x, y, width, colour); }, is_inside);
    if (kind == 6)
        check_drawn(
            canvas, [&] { draw_circle(canvas, mode, x, y, width, colour); },
            [&](PixelPosition pixel) {
                const auto [column, row] = pixel;
                const bool is_border = !is_inside({column - 1, row}) || !is_inside({column + 1, row}) ||
                                       !is_inside({column, row - 1}) || !is_inside({column, row + 1});
                return !is_inside(pixel) ? kNone : is_border ? index : kUnknown;
            });
    if (kind == 7) {
        const auto clamped = [](PixelPosition corner) {
            constexpr std::int32_t kMost = 1 << 20;
            return PixelPosition{std::clamp(corner.column, -kMost, kMost), std::clamp(corner.row, -kMost, kMost)};
        };
        check([&] { fill_triangle(canvas, at, second, third, colour); },
              [&](PixelPosition pixel) {
                  return is_in_triangle({clamped(at), clamped(second), clamped(third)}, pixel);
              });
    }
    if (kind == 8) {
        const ScreenMode any{third.column, third.row, {width, height}};
        expect(accepts([&] { fill_circle(canvas, any, x, y, 20, colour); }) == is_allowed(any) &&
                   accepts([&] { draw_circle(canvas, any, x, y, 20, colour); }) == is_allowed(any),
               "a mode that windows can have");
    }
    const PlainRectangle all{0, 0, canvas.width_px, canvas.height_px};
    expect(pixel_at(canvas, x, y) == (all.has(x, y) ? canvas.row(y)[x] : 0), "the pixel's colour");
}

void Session::stamp() {
    Framebuffer canvas;
    if (!choose(canvas)) return;
    const Picture source = picture();
    const PixelPosition at = position();
    const std::int32_t degrees = number(), scale = number();
    const std::int32_t x = at.column, y = at.row;
    const auto texel_or_none = [](int texel) { return texel == kTransparent ? kNone : texel; };
    const PlainRectangle area{x, y, source.width_px, source.height_px};
    bool is_taken = true;
    const std::size_t kind = below(5);
    if (kind == 0) {
        check_drawn(
            canvas, [&] { is_taken = accepts([&] { draw_picture(canvas, source, x, y); }); },
            [&](PixelPosition pixel) {
                if (!is_taken || !area.has(pixel.column, pixel.row)) return kNone;
                const auto texel = (pixel.row - area.y) * area.width + pixel.column - area.x;
                return texel_or_none(source.pixels[static_cast<std::size_t>(texel)]);
            });
        expect(is_taken == is_whole(source), "a picture with all of its pixels");
    } else if (kind == 1) {
        check_drawn(
            canvas, [&] { is_taken = accepts([&] { draw_turned(canvas, source, x, y, degrees, scale); }); },
            [&](PixelPosition pixel) {
                return !is_taken || scale < 1 ? kNone : texel_or_none(turned_texel(source, at, degrees, scale, pixel));
            });
    } else if (kind == 2) {
        const PicturePart part{number(),      number(),      degrees,       scale,
                               below(2) != 0, below(2) != 0, below(2) != 0, number()};
        const std::int64_t times = std::clamp(part.scale, 1, kLargestMode_px);
        const PlainRectangle whole{x, y, part.width_px * times, part.height_px * times};
        check_drawn(
            canvas, [&] { accepts([&] { draw_part(canvas, source, part, x, y); }); },
            [&](PixelPosition pixel) { return whole.has(pixel.column, pixel.row) ? kUnknown : kNone; });
    } else if (kind == 3) {
        const std::string text = bytes();
        const std::int64_t times = std::clamp(scale, 1, 256);
        const PlainRectangle line{x, y - 2 * times, 6 * times * std::ssize(text), 10 * times};
        check_drawn(
            canvas, [&] { draw_label(canvas, x, y, text, degrees, scale); },
            [&](PixelPosition pixel) { return line.has(pixel.column, pixel.row) ? kUnknown : kNone; });
    } else {
        static const test::TemporaryFolder folder;
        const std::string file = folder.path("saved.png");
        const bool is_saved = accepts([&] { save_picture(file, canvas, greys()); });
        expect(is_saved == (canvas.width_px > 0 && canvas.height_px > 0), "a file of a picture with pixels");
        if (is_saved)
            expect(checksum(load_picture(file, greys()).canvas()) == checksum(canvas), "the picture that was saved");
    }
}

void Session::compute() {
    const std::int64_t any = below(2) ? std::int64_t{number()} << 32 | byte() : number();
    expect(
        std::abs(sine_65536(any) - 65536 * std::sin(static_cast<double>(any % 92'160) * std::numbers::pi / 46'080)) < 8,
        "the sine");
    std::uint64_t state = static_cast<std::uint64_t>(any);
    const std::int32_t limit = number(), random = random_below(limit, state);
    expect(random >= 0 && random < std::max(limit, 1), "a number below the limit");
    const std::int64_t other = number();
    const double turn = std::atan2(static_cast<double>(other), static_cast<double>(any)) * 46'080 / std::numbers::pi;
    expect(std::abs(std::remainder(direction_256(any, other) - turn, 92'160)) < 2, "the direction");
    const auto root = static_cast<double>(integer_root(static_cast<std::uint64_t>(any)));
    expect(std::abs(root - std::sqrt(static_cast<double>(static_cast<std::uint64_t>(any)))) <= 1, "the root");
    project(pose(), pose(), kSmall, number());
    const Pose from = pose();
    const std::int32_t ahead = number(), right = number(), up = number();
    const Pose to = moved(from, ahead, right, up);
    const double yaw = from.yaw_256 * std::numbers::pi / 46'080, sine = std::sin(yaw), cosine = std::cos(yaw);
    const auto is_near = [&](std::int32_t is, double should_be) {
        return std::abs(is - std::clamp(should_be, -2'048e6, 2'048e6)) <=
               2 + 2e-4 * (std::abs(1.0 * ahead) + std::abs(1.0 * right));
    };
    expect(is_near(to.x_256, from.x_256 + ahead * cosine + right * sine), "moved in x");
    expect(is_near(to.y_256, from.y_256 + ahead * sine - right * cosine), "moved in y");
    expect(is_near(to.z_256, from.z_256 + 1.0 * up), "moved in z");
}

void Session::use_palette() {
    const std::int32_t first = number(), last = number(), places = number();
    const bool is_part = first >= 0 && first <= last && last <= 255, turns = below(2);
    const Palette before = palette_;
    const Rgb8 from{byte(), byte(), byte()}, to{byte(), byte(), byte()};
    expect(is_part == accepts([&] {
               turns ? cycle_colours(palette_, first, last, places) : set_ramp(palette_, first, last, from, to);
           }),
           "a part of the palette");
    for (std::int32_t i = 0; i < 256; ++i) {
        const auto at = [&](std::int64_t number) { return before.colours[static_cast<std::size_t>(number)]; };
        const bool is_in = is_part && i >= first && i <= last;
        const std::int64_t count = is_in ? last - first + 1 : 1, step = is_in ? i - first : 0;
        if (is_in && !turns)
            expect(std::abs(palette_.colours[static_cast<std::size_t>(i)].red -
                            (from.red +
                             (to.red - from.red) * double(step) / double(std::max<std::int64_t>(count - 1, 1)))) <= 1,
                   "an even gradient");
        else
            expect(palette_.colours[static_cast<std::size_t>(i)] ==
                       (is_in ? at(first + ((step - places) % count + count) % count) : at(i)),
                   "colours moved");
    }
}

void Session::use_window() {
    window_.call(*this);
}

void Session::use_speaker() {
    static Speaker speaker;
    static std::int32_t sounds = 0;
    const std::int32_t rate = number(), sound = number();
    const std::vector<std::int16_t> samples(below(3));
    if (accepts([&] { expect(speaker.add(samples, rate) == sounds, "the next number"); })) ++sounds;
    expect(accepts([&] { speaker.play(sound, number(), number()); }) == (sound >= 0 && sound < sounds),
           "a known sound");
    if (below(2)) accepts([&] { speaker.play_music(bytes(), number()); });
    speaker.stop_music();
}

void Session::build() {
    OwnModel& built = model();
    const std::string corpus = test::source_folder() + "/tests/fuzz/corpus/";
    const auto load = [&](const std::string& file) {
        const std::int32_t scale = number();
        if (!accepts([&] { built.model = std::make_unique<Model>(file, greys(), scale); })) return;
        built.pictures = built.model->add_picture(Picture::of_size(1, 1)) + 1;
    };
    const std::size_t kind = below(9);
    if (kind == 0) return void(built = {});
    if (kind == 8) {
        const std::int32_t scale = number();
        if (accepts([&] { built.model = std::make_unique<Model>(Model::sprite(picture(), scale)); }))
            built.pictures = 1;
        return;
    }
    if (kind == 1) return load(corpus + "mdl/tetrahedron.mdl");
    if (kind == 2) return load(level_file().substr(0, level_file().rfind('/')) + "/t.obj");
    if (kind < 5) {
        const Picture& added = picture();
        const bool is_taken =
            accepts([&] { expect(built.model->add_picture(added) == built.pictures, "the next number"); });
        expect(is_taken == (is_whole(added) && !added.pixels.empty()), "a picture with all of its pixels");
        built.pictures += is_taken;
        return;
    }
    const Corner a = corner(), b = corner(), c = corner();
    const std::int32_t shown = static_cast<std::int32_t>(below(5)) - 1;
    expect(accepts([&] { built.model->add_triangle(a, b, c, shown); }) == (shown >= 0 && shown < built.pictures),
           "a picture that was added");
    expect(built.model->frame_count() >= 1, "a frame");
    const auto [least, greatest] = built.model->bounds(number());
    expect(least.x_256 <= greatest.x_256 && least.z_256 <= greatest.z_256, "a box");
}

template <class Show>
void Session::show_models(Show show) {
    for (std::size_t count = below(3); count > 0; --count) show(*model().model, pose(), number());
}

void Session::use_stage() {
    static Twins<Stage> stages(greys(), kSmall);
    Framebuffer other;
    if (choose(other))
        show_models([&](const Model& shown, const Pose& at, std::int32_t frame) {
            accepts([&] { stages.used.draw(shown, at, other, frame); });
        });
    Picture first = Picture::of_size(kSmall.width_px, kSmall.height_px);
    show_models([&](const Model& shown, const Pose& at, std::int32_t frame) {
        stages.used.draw(shown, at, first.canvas(), frame);
    });
    const Pose eye = pose();
    const std::int32_t view = number(), ambient = number(), side = number(), x = number(), y = number(), z = number();
    stages.change([&](Stage& stage) {
        stage.set_light(ambient, side, x, y, z);
        stage.look(eye, view);
    });
    const Model& shown = *model().model;
    const Pose place = pose();
    const std::int32_t frame = number();
    const bool are_edges = below(3) == 0;
    stages.demand_same_picture([&](Stage& stage, Framebuffer canvas) {
        are_edges ? stage.draw_edges(shown, place, side, canvas, frame) : stage.draw(shown, place, canvas, frame);
    });
}

// As they are at the beginning.
Twins<LevelScene>& Session::scenes() {
    static Twins<LevelScene> both(level_file(), greys(), kSmall);
    if (!std::exchange(has_scenes_, true))
        both.change([](LevelScene& scene) {
            for (std::int32_t i = 0; i < std::ssize(scene.level().entities); ++i) {
                accepts([&] { scene.move_entity(i, 0, 0, 0); });
                accepts([&] { scene.turn_entity(i, 0); });
                accepts([&] { scene.hide_entity(i, false); });
            }
            scene.settings() = {};
        });
    return both;
}

void Session::use_level() {
    LevelScene& scene = scenes().used;
    const auto& entities = scene.level().entities;
    const std::int32_t entity = below(8) == 0 ? number() : static_cast<std::int32_t>(below(entities.size())),
                       east = number(), north = number(), up = number();
    const bool is_there = entity >= 0 && entity < std::ssize(entities);
    constexpr const char* kPresets[] = {"1991", "1994", "1996", "pixel", "bounded", "exact", "", "none"};
    const std::size_t kind = below(8);
    if (kind == 6) {
        const bool is_hidden = below(2) != 0;
        if (accepts([&] { scene.hide_entity(entity, is_hidden); })) hidden_[entity] = is_hidden;
    } else if (kind == 7) {
        expect(accepts([&] {
                   scene.entity_pose(entity);
                   scene.touches(pose(), entity);
               }) == is_there,
               "an entity that is there");
    } else if (kind == 0) {
        if (accepts([&] { scene.move_entity(entity, east, north, up); })) moved_[entity] = {east, north, up};
    } else if (kind == 1) {
        if (accepts([&] { scene.turn_entity(entity, east); })) turned_[entity] = east;
    } else if (kind == 2) {
        accepts([&] { scene.set_accuracy(kPresets[below(std::size(kPresets))]); });
    } else if (kind == 3) {
        const std::int32_t found = scene.find_entity("classname", "light", entity);
        expect(found == -1 || (found > entity && scene.entity_value(found, "classname") == "light"), "a light");
    } else if (kind == 4) {
        expect(accepts([&] { scene.entity_value(entity, bytes()); }) == is_there, "an entity that is there");
    } else {
        scene.palette_at(pose(), std::int64_t{east} << below(33));
        expect(scene.start().z_256 > 0, "the same start");
    }
}

void Session::draw_level() {
    Twins<LevelScene>& both = scenes();
    both.fresh.settings() = both.used.settings();
    for (const auto& [entity, by] : moved_) both.fresh.move_entity(entity, by[0], by[1], by[2]);
    for (const auto& [entity, degrees] : turned_) both.fresh.turn_entity(entity, degrees);
    for (const auto& [entity, is_hidden] : hidden_) both.fresh.hide_entity(entity, is_hidden);
    show_models([&](const Model& shown, const Pose& at, std::int32_t frame) {
        both.change([&](LevelScene& scene) { scene.show(shown, at, frame); });
    });
    if (below(4) == 0) model() = {};
    Framebuffer other;
    if (choose(other)) accepts([&] { both.used.draw({}, 0, other); });
    const Pose eye = below(2) ? both.used.start() : pose();
    const std::int64_t time_ms = std::int64_t{number()} << below(33);
    const std::int32_t view = number();
    both.demand_same_picture([&](LevelScene& scene, Framebuffer canvas) { scene.draw(eye, time_ms, canvas, view); });
}

void Session::walk() {
    const LevelScene& scene = scenes().used;
    const Pose from = pose(), to = pose(), reached = scene.walked(from, to);
    scene.stands(from);
    const auto is_in_room = [](const Pose& at, std::int32_t wall = 128) {
        return std::max({std::abs(std::int64_t{at.x_256}), std::abs(std::int64_t{at.y_256}),
                         std::abs(std::int64_t{at.z_256})}) < wall * 256;
    };
    const Hit hit = scene.ray(from, number());
    expect(!is_in_room(from) || is_in_room(hit.place, 144), "a ray that does not leave the room and its sky");
    expect(!is_in_room(from) || is_in_room(reached), "a body that does not leave the room");
    expect(reached.yaw_256 == to.yaw_256 && reached.roll_256 == to.roll_256, "the wanted direction");
}

}  // namespace

void run(Input input) {
    setenv("OBLONG_HEADLESS", "1", 1);
    Session(input).run();
}

}  // namespace oblong::fuzz
