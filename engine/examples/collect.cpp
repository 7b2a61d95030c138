// Collecting in a level: its lenses, and sparks of this program's own, which are pictures that turn to the eye. The
// nearer the next one, the louder the hum; a note and a flash tell that one was taken, and the line below what is
// ahead. Arrow keys walk.
//
// Usage: example_collect [ASSETS]
#include <oblong.h>

#include <algorithm>

using namespace oblong;

namespace {

constexpr int kHeard = 400, kInk = 239;

Picture make_spark() {
    Picture spark = Picture::of_size(17, 17);
    clear(spark.canvas(), kTransparent);
    for (const int end : {2, 8, 14}) draw_line(spark.canvas(), end, 0, 16 - end, 16, kInk);
    draw_line(spark.canvas(), 0, 8, 16, 8, kInk);
    fill_circle(spark.canvas(), {17, 17, {1, 1}}, 8, 8, 5, 229);
    return spark;
}

int distance(const Pose& a, const Pose& b) {
    const std::int64_t east = a.x_256 - b.x_256, north = a.y_256 - b.y_256;
    return static_cast<int>(integer_root(static_cast<std::uint64_t>(east * east + north * north)) / 256);
}

Pose walked(const LevelScene& level, Pose eye, const Window& window, int passed_ms) {
    eye.yaw_256 += (window.is_down("Left") - window.is_down("Right")) * passed_ms * 30;
    const int ahead_256 = (window.is_down("Up") - window.is_down("Down")) * passed_ms * 50;
    return level.walked(eye, moved(eye, ahead_256, 0, -passed_ms * 50));
}

}  // namespace

int main(int argc, char** argv) try {
    const std::string assets = argc > 1 ? argv[1] : "build/assets";
    Window window("Collect");
    LevelScene level(assets + "/demo.bsp", load_palette(assets + "/palette.lmp"), window.mode());
    const Model spark = Model::sprite(make_spark());
    Speaker speaker;
    const int note = speaker.load(assets + "/sounds/note1.flac");
    const std::int64_t hum = speaker.play(speaker.load(assets + "/sounds/hum.flac"), 0, 0, true);
    speaker.play_music(assets + "/music/title.mod");
    Pose eye = level.start();
    std::vector<int> lenses;
    for (int lens = -1; (lens = level.find_entity("classname", "item_lens", lens)) >= 0;) lenses.push_back(lens);
    std::vector<Pose> sparks;
    for (int i = 1; i < 6; ++i) sparks.push_back(moved(eye, i * 60 * 256, (i % 3 - 1) * 30 * 256, -20 * 256));
    std::int64_t shown_ms = 0, taken_ms = -1000, taken = 0;
    do {
        eye = walked(level, eye, window, static_cast<int>(std::min<std::int64_t>(window.time_ms() - shown_ms, 100)));
        shown_ms = window.time_ms();
        int nearest = kHeard;
        const auto takes = [&](const Pose& place, bool is_touched) {
            nearest = std::min(nearest, distance(eye, place));
            if (is_touched) ++taken, taken_ms = shown_ms, speaker.play(note);
            return is_touched;
        };
        std::erase_if(sparks, [&](const Pose& place) { return takes(place, distance(eye, place) < 24); });
        for (const int lens : lenses)
            if (takes(level.entity_pose(lens), level.touches(eye, lens))) level.hide_entity(lens);
        std::erase_if(lenses, [&](int lens) { return level.touches(eye, lens); });
        speaker.set_volume(hum, 256 - nearest * 256 / kHeard);
        speaker.set_music_volume(speaker.is_playing(hum) ? 60 : 256);
        for (const Pose& place : sparks) level.show(spark, place);
        level.draw(eye, shown_ms, window.canvas());
        const Hit hit = level.ray(eye, 1000);
        const std::string ahead = hit.entity < 0 ? "a wall" : level.entity_value(hit.entity, "classname");
        draw_label(window.canvas(), 6, 6, std::to_string(taken) + " taken; ahead: " + ahead, kInk);
        const std::int64_t flash_256 = std::max<std::int64_t>(160 - (shown_ms - taken_ms) / 2, 0);
        window.palette = mixed(level.palette_at(eye, shown_ms), {255, 240, 180}, static_cast<int>(flash_256));
        if (window.was_pressed("M")) speaker.stop(hum);
    } while (window.show());
} catch (const std::exception& error) {
    return report(error);
}
