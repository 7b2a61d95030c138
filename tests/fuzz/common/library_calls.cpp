#include "tests/fuzz/common/library_calls.h"

#include <algorithm>
#include <limits>

namespace oblong::fuzz {
namespace {

constexpr const char* kInputs[] = {"Space", "Mouse 1", "Wheel Up", "Pad A", "Pad Left Stick Up"};

std::int32_t nearest_32(std::int64_t number) {
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(number, std::numeric_limits<std::int32_t>::min(),
                                                              std::numeric_limits<std::int32_t>::max()));
}

std::int32_t pixel_under(std::int64_t at, std::int64_t size, std::int64_t pixels) {
    const std::int64_t product = at * pixels;
    return nearest_32(product / size - (product % size < 0));
}

}  // namespace

std::int32_t LibraryCalls::number() {
    const std::uint8_t kind = byte();
    if (kind < 128) return kind - 32;
    const std::uint32_t power = (1u << (kind & 31)) - (kind >> 6 & 1);
    return static_cast<std::int32_t>(kind & 32 ? power : 0 - power);
}

std::string LibraryCalls::bytes() {
    std::string text;
    for (std::size_t count = below(9); count > 0; --count) text += static_cast<char>(byte() | 1);
    return text;
}

bool is_allowed(const ScreenMode& mode) {
    const auto is_among = [](std::int64_t number, std::int64_t most) { return number >= 1 && number <= most; };
    const auto [width, height] = mode.display;
    return is_among(mode.width_px, 4096) && is_among(mode.height_px, 4096) && is_among(width, 10'000) &&
           is_among(height, 10'000) && width <= 100 * height && height <= 100 * width;
}

bool is_whole(const Picture& picture) {
    return picture.width_px >= 0 && picture.height_px >= 0 &&
           std::int64_t{picture.width_px} * picture.height_px == std::ssize(picture.pixels);
}

void FedWindow::call(LibraryCalls& arguments) {
    const std::int32_t width = arguments.number(), height = arguments.number();
    const std::size_t kind = arguments.below(8);
    if (kind == 0) {
        size_ = {width, height};
    } else if (kind == 1) {
        const ScreenMode before = window_.mode(), mode{width, height, {arguments.number(), arguments.number()}};
        const bool is_taken = accepts([&] { window_.set_mode(mode); });
        expect(is_taken == is_allowed(mode), "a mode that windows can have");
        expect(window_.mode() == (is_taken ? mode : before), "the mode that was set");
        if (width > 100 || height > 100) window_.set_mode({24, 16});
        const auto is_black = [&](PixelPosition) { return is_taken ? 0 : kUnknown; };
        check_drawn(
            window_.canvas(), [] {}, is_black);
    } else if (kind == 2) {
        now_us_ = static_cast<std::uint64_t>(std::int64_t{width} << arguments.below(33));
    } else if (kind == 3) {
        window_.capture_mouse(width & 1);
        window_.set_full_screen(height & 1);
        accepts([&] { window_.is_down(arguments.bytes()); });
    } else if (kind == 4) {
        next_.pointer = Pointer{width, height, false, false};
    } else if (kind == 5) {
        show();
    } else {
        feed(arguments);
    }
}

void FedWindow::feed(LibraryCalls& arguments) {
    const auto kind = static_cast<InputEvent::Kind>(arguments.below(9));
    const oblong::Input input = input_named(kInputs[arguments.below(std::size(kInputs))]);
    next_.events.push_back({kind, input, arguments.number(), arguments.number()});
}

void FedWindow::show() {
    presses_.clear();
    motion_ = {};
    std::erase_if(held_256_, [](const auto& held) { return held.first.device == Device::MouseWheel; });
    for (const InputEvent& event : next_.events) expect_event(event);
    const PresentRect shown = layout(size_, window_.mode(), ShownAs::OnDisplay, Scaling::SharpBilinear);
    if (next_.pointer && shown.width_px > 0)
        mouse_ = {
            pixel_under(std::int64_t{next_.pointer->x_px} - shown.x_px, shown.width_px, window_.mode().width_px),
            pixel_under(std::int64_t{next_.pointer->y_px} - shown.y_px, shown.height_px, window_.mode().height_px)};
    expect(window_.show(), "an open window");
    check();
}

void FedWindow::expect_event(const InputEvent& event) {
    using Kind = InputEvent::Kind;
    const Kind kind = event.kind;
    const oblong::Input input = event.input;
    const std::int32_t x = event.x, y = event.y;
    const auto release = [&](auto is_one) { std::erase_if(held_256_, [&](auto& held) { return is_one(held.first); }); };
    if (kind == Kind::Press || kind == Kind::Click || (kind == Kind::Axis && x > 0)) {
        if (kind != Kind::Axis || !held_256_.contains(input)) ++presses_[input];
        held_256_[input] =
            kind == Kind::Axis ? static_cast<std::int32_t>(std::min(x, kFullAxis) * 256 / kFullAxis) : 256;
    } else if (kind == Kind::Release || kind == Kind::Axis) {
        held_256_.erase(input);
    } else if (kind == Kind::MouseMotion) {
        motion_ = {nearest_32(std::int64_t{motion_.column} + x), nearest_32(std::int64_t{motion_.row} + y)};
    } else if (kind == Kind::ReleasePressed) {
        release([](oblong::Input one) { return one.device != Device::PadAxis; });
    } else if (kind == Kind::ReleasePad || kind == Kind::ReleaseAll) {
        release([&](oblong::Input one) { return kind == Kind::ReleaseAll || is_of_pad(one); });
    }
}

void FedWindow::check() {
    for (const char* name : kInputs) {
        const oblong::Input input = input_named(name);
        const std::int32_t count = presses_[input], pressure = held_256_.contains(input) ? held_256_[input] : 0;
        expect(window_.press_count(name) == count && window_.was_pressed(name) == (count > 0), "presses counted");
        expect(window_.pressure_256(name) == pressure && window_.is_down(name) == (pressure >= 64), "what is held");
    }
    expect(window_.mouse_motion() == motion_, "the mouse's motion");
    expect(window_.mouse() == mouse_, "the pixel under the mouse");
}

}  // namespace oblong::fuzz
