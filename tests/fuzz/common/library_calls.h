#pragma once

#include <map>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include "engine/library/oblong.h"
#include "engine/platform/platform.h"
#include "tests/fuzz/common/fuzz.h"
#include "tests/fuzz/common/plain_drawing.h"

namespace oblong::fuzz {

/// The arguments of calls, read from the bytes of an input; zeros behind its end.
class LibraryCalls {
  public:
    explicit LibraryCalls(Input bytes) : bytes_(bytes) {}

    bool are_left() const { return at_ < bytes_.size(); }
    std::uint8_t byte() { return are_left() ? bytes_[at_++] : std::uint8_t{0}; }
    std::size_t below(std::size_t limit) { return byte() % limit; }
    /// A small number, or a power of two or one less; or the negative.
    std::int32_t number();
    /// A few bytes, none of them 0.
    std::string bytes();

  private:
    Input bytes_;
    std::size_t at_ = 0;
};

/// Whether a call is not refused; a refusal says what was expected.
template <class Call>
bool accepts(Call call) {
    try {
        call();
        return true;
    } catch (const std::runtime_error& error) {
        expect(*error.what() != 0, "a reason");
        return false;
    }
}

bool is_allowed(const ScreenMode& mode);
bool is_whole(const Picture& picture);

/// Demands of each pixel the colour that `rule` gives for its position; or kNone, the one before; or kUnknown.
template <class Draw, class Rule>
void check_drawn(Framebuffer canvas, Draw draw, Rule rule) {
    std::vector<std::uint8_t> before;
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        before.insert(before.end(), canvas.row(y), canvas.row(y) + canvas.width_px);
    draw();
    auto was = before.begin();
    for (std::int32_t y = 0; y < canvas.height_px; ++y)
        for (std::int32_t x = 0; x < canvas.width_px; ++x, ++was) {
            const int is = canvas.row(y)[x], expected = rule(PixelPosition{x, y});
            if (expected != kUnknown)
                expect(is == (expected == kNone ? *was : expected), "another colour than " + std::to_string(is) +
                                                                        " at " + std::to_string(x) + ", " +
                                                                        std::to_string(y));
        }
}

/// A window on a platform that gives any input, and what must be said of it.
class FedWindow : Platform {
  public:
    void call(LibraryCalls& arguments);

  private:
    bool is_open() const override { return true; }
    PlatformInput poll() override { return std::exchange(next_, {}); }
    std::uint64_t now_us() override { return now_us_; }
    WindowSize window_size() const override { return size_; }
    void set_title(const char*) override {}
    void present(Framebuffer, const Palette&, const PresentRect&) override {}

    void feed(LibraryCalls& arguments);
    void show();
    void expect_event(const InputEvent& event);
    void check();

    PlatformInput next_;
    std::uint64_t now_us_ = 0;
    WindowSize size_{640, 480};
    Window window_{*this, {24, 16}};
    std::map<oblong::Input, std::int32_t> held_256_, presses_;
    PixelPosition motion_, mouse_;
};

}  // namespace oblong::fuzz
