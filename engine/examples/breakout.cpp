// Bricks: a ball that meets boxes, a menu, and the best score in a file that an argument names, or beside the program.
// The mouse moves the racket, a click or Space begins, Escape goes back to the menu, where nobody plays, then ends.
#include <oblong.h>

#include <algorithm>
#include <fstream>

using namespace oblong;

namespace {

constexpr int kBall_px = 4, kRacket_px = 40, kInk = 255, kFirstBrick = 240;

struct Box {
    int x, y, width, height;
    bool meets(const Box& b) const {
        return x < b.x + b.width && b.x < x + width && y < b.y + b.height && b.y < y + height;
    }
    void fill(Framebuffer canvas, int colour) const { fill_rectangle(canvas, x, y, width, height, colour); }
};

struct Game {
    std::vector<Box> bricks;
    Box racket{0, 186, kRacket_px, 4};
    int x_256 = 90 * 256, y_256 = 120 * 256, right_256 = 300, down_256 = 380, score = 0;

    Game() {
        for (int i = 0; i < 60; ++i) bricks.push_back({12 + i % 10 * 30, 24 + i / 10 * 12, 26, 8});
    }
    Box ball() const { return {x_256 / 256, y_256 / 256, kBall_px, kBall_px}; }
    bool is_over() const { return y_256 >= 200 * 256 || bricks.empty(); }

    // Moves the ball along one axis; where it meets something, it turns.
    void move(int& at_256, int& way_256) {
        at_256 += way_256;
        const auto bricks_hit = std::erase_if(bricks, [&](const Box& brick) { return brick.meets(ball()); });
        score += static_cast<int>(bricks_hit) * 10;
        if (bricks_hit > 0 || ball().x < 4 || ball().x > 312 || ball().y < 12) at_256 -= way_256, way_256 = -way_256;
    }
    void tick() {  // a hundredth of a second
        move(x_256, right_256);
        move(y_256, down_256);
        if (down_256 <= 0 || !racket.meets(ball())) return;
        down_256 = -std::min(down_256 + 4, 900);
        right_256 = (ball().x + kBall_px / 2 - racket.x - kRacket_px / 2) * 20;
    }
};

}  // namespace

int main(int argc, char** argv) try {
    Window window("Bricks");
    set_ramp(window.palette, kFirstBrick, kFirstBrick + 5, {240, 90, 60}, {240, 220, 120});
    const std::string file = argc > 1 ? argv[1] : beside_program("example_breakout.txt");
    int best = 0;
    std::ifstream(file) >> best;
    Game game;
    bool is_played = false;
    for (std::int64_t ticked_ms = 0; window.show();) {
        if (window.was_pressed("Escape")) is_played ? void(is_played = false) : window.close();
        if (!is_played && (window.was_pressed("Space") || window.was_pressed("Mouse 1"))) game = {}, is_played = true;
        for (; ticked_ms < window.time_ms() && !game.is_over(); ticked_ms += 10) {
            game.racket.x = (is_played ? window.mouse().column : game.ball().x) - kRacket_px / 2;
            game.tick();
        }
        if (game.is_over() && is_played && game.score > best) std::ofstream(file) << (best = game.score);
        if (game.is_over()) is_played = false, game = {};
        const Framebuffer canvas = window.canvas();
        clear(canvas);
        draw_rectangle(canvas, 3, 11, 314, 200, kInk);
        for (const Box& brick : game.bricks) brick.fill(canvas, kFirstBrick + brick.y / 12 - 2);
        game.racket.fill(canvas, kInk);
        game.ball().fill(canvas, kInk);
        draw_label(canvas, 8, 2, "score " + std::to_string(game.score) + "  best " + std::to_string(best), kInk);
        if (!is_played) draw_label(canvas, 91, 140, "SPACE OR A CLICK BEGINS", kInk);
    }
} catch (const std::exception& error) {
    return report(error);
}
