#include <algorithm>
#include <cstdlib>
#include <limits>
#include <map>
#include <memory>
#include <stdexcept>

#include "engine/base/text.h"
#include "engine/library/conversions.h"
#include "engine/platform/headless.h"
#include "engine/platform/sdl/sdl.h"

namespace oblong {
namespace {

constexpr std::int64_t kHeadlessRate_hz = 70;

// Even colours, then greys from black to white.
Palette even_palette() {
    Palette palette = even_colours();
    set_ramp(palette, 216, 255, {0, 0, 0}, {255, 255, 255});
    return palette;
}

std::int32_t nearest_32(std::int64_t any) {
    using Limits = std::numeric_limits<std::int32_t>;
    return static_cast<std::int32_t>(std::clamp<std::int64_t>(any, Limits::min(), Limits::max()));
}

// OBLONG_HEADLESS: FRAMES or FRAMES:FILE.png.
std::unique_ptr<Platform> open_headless(const std::string& text) {
    const std::size_t colon = text.find(':');
    const std::string digits = text.substr(0, colon), file = colon == text.npos ? "" : text.substr(colon + 1);
    const bool is_number = !digits.empty() && digits.size() < 10 &&
                           digits.find_first_not_of("0123456789") == digits.npos && std::stoll(digits) > 0;
    if (!is_number)
        throw std::runtime_error("OBLONG_HEADLESS: '" + text + "', expected FRAMES or FRAMES:FILE.png, one or more");
    const std::int64_t frames = std::stoll(digits);
    const auto save_last = [frames, file, shown = std::int64_t{0}](Framebuffer picture,
                                                                   const Palette& palette) mutable {
        if (++shown == frames && !file.empty()) save_picture(file, picture, palette);
    };
    return std::make_unique<HeadlessPlatform>(
        frames, kHeadlessRate_hz, [](std::int64_t) { return PlatformInput{}; }, save_last);
}

std::unique_ptr<Platform> open_platform(const std::string& title, WindowSize size) {
    if (const char* headless = std::getenv("OBLONG_HEADLESS")) return open_headless(headless);
    return open_window(title.c_str(), size);
}

constexpr std::uint16_t kOfEachPad = 256;  // times the pad's number, in the codes of pad_events

std::int32_t number_of_pad(Input input) {
    return input.code / kOfEachPad;
}

// Of "Pad 2 A", too, which is "Pad A" of the second.
Input named(std::string_view name) {
    constexpr std::string_view kPad = "pad ";
    const bool has_number = name.size() > kPad.size() + 1 && lower_case(name.substr(0, kPad.size())) == kPad &&
                            name[kPad.size()] >= '1' && name[kPad.size()] <= '9' && name[kPad.size() + 1] == ' ';
    if (!has_number) return input_named(name);
    Input input = input_named("Pad" + std::string(name.substr(kPad.size() + 1)));
    input.code = static_cast<std::uint16_t>(input.code + kOfEachPad * (name[kPad.size()] - '0'));
    return input;
}

}  // namespace

struct Window::State {
    State(std::unique_ptr<Platform> opened, Platform& shown_by, const ScreenMode& its_mode)
        : owned(std::move(opened)), platform(shown_by), mode(checked(its_mode)), start_us(platform.now_us()) {
        pixels.resize(pixel_count(mode.width_px, mode.height_px));
    }

    PresentRect shown() const {
        return layout(platform.window_size(), mode, ShownAs::OnDisplay, Scaling::SharpBilinear);
    }
    void take_input();
    void take(const InputEvent& event);
    void point(const Pointer& pointer);

    std::unique_ptr<Platform> owned;  // null if the program passed its own
    Platform& platform;
    ScreenMode mode;
    std::vector<std::uint8_t> pixels;
    std::uint64_t start_us;
    std::int64_t time_us = 0;
    bool is_closed = false;
    WindowSettings settings;
    std::map<Input, std::int32_t> held;    // pressed inputs, with their pressures: 1 to kFullAxis
    std::vector<Input> pressed, released;  // since the last picture
    std::string typed;                     // in this time
    PixelPosition mouse, motion;
};

void Window::State::take(const InputEvent& event) {
    using Kind = InputEvent::Kind;
    const bool was_held = held.contains(event.input);
    switch (event.kind) {
        case Kind::Press:
        case Kind::Click:
            held[event.input] = kFullAxis;
            pressed.push_back(event.input);
            return;
        case Kind::Release:
            held.erase(event.input);
            released.push_back(event.input);
            return;
        case Kind::Axis:
            if (event.x > 0)
                held[event.input] = std::min(event.x, kFullAxis);
            else
                held.erase(event.input);
            break;
        case Kind::MouseMotion:
            motion = {nearest_32(std::int64_t{motion.column} + event.x),
                      nearest_32(std::int64_t{motion.row} + event.y)};
            break;
        case Kind::ReleasePressed:
            std::erase_if(held, [](const auto& one) { return one.first.device != Device::PadAxis; });
            break;
        case Kind::ReleasePad:
            std::erase_if(held, [&](const auto& one) {
                return is_of_pad(one.first) && number_of_pad(one.first) == number_of_pad(event.input);
            });
            break;
        case Kind::ReleaseAll:
            held.clear();
            break;
        case Kind::Repeat:
            break;
    }
    const bool is_held = held.contains(event.input);
    if (!was_held && is_held) pressed.push_back(event.input);
    if (was_held && !is_held) released.push_back(event.input);
}

// Converts a position in the window to a pixel of the canvas.
void Window::State::point(const Pointer& pointer) {
    const PresentRect rect = shown();
    if (rect.width_px == 0 || rect.height_px == 0) return;
    const auto scaled = [](std::int64_t at, std::int64_t from, std::int64_t to) {
        const std::int64_t product = at * to;
        return nearest_32((product - (product < 0 ? from - 1 : 0)) / from);
    };
    mouse = {scaled(std::int64_t{pointer.x_px} - rect.x_px, rect.width_px, mode.width_px),
             scaled(std::int64_t{pointer.y_px} - rect.y_px, rect.height_px, mode.height_px)};
}

void Window::State::take_input() {
    pressed.clear();
    released.clear();
    motion = {};
    std::erase_if(
        held, [](const auto& one) { return one.first.device == Device::MouseWheel; });  // wheel turns have no release
    PlatformInput input = platform.poll();
    for (const auto* events : {&input.events, &input.pad_events})
        for (const InputEvent& event : *events) take(event);
    typed = std::move(input.text);
    if (input.pointer) point(*input.pointer);
    if (input.changes_full_screen) settings.is_full_screen = !settings.is_full_screen;
    platform.change_window(settings);
}

Window::Window(const std::string& title, ScreenMode mode, WindowSize size) : palette(even_palette()) {
    checked(mode);
    std::unique_ptr<Platform> platform = open_platform(title, size);
    Platform& shown_by = *platform;
    state_.reset(new State(std::move(platform), shown_by, mode));
}

Window::Window(Platform& platform, ScreenMode mode)
    : palette(even_palette()), state_(new State(nullptr, platform, mode)) {}

Window::~Window() = default;
Window::Window(Window&& other) noexcept = default;
Window& Window::operator=(Window&& other) noexcept = default;

bool Window::show() {
    State& state = *state_;
    state.platform.present(canvas(), palette, state.shown());
    state.take_input();
    state.time_us = static_cast<std::int64_t>(state.platform.now_us() - state.start_us);
    return state.platform.is_open() && !state.is_closed;
}

void Window::close() {
    state_->is_closed = true;
}

Framebuffer Window::canvas() {
    return {state_->pixels.data(), state_->mode.width_px, state_->mode.height_px, state_->mode.width_px};
}

const ScreenMode& Window::mode() const {
    return state_->mode;
}

void Window::set_mode(const ScreenMode& mode) {
    state_->mode = checked(mode);
    state_->pixels.assign(pixel_count(mode.width_px, mode.height_px), 0);
}

std::int64_t Window::time_ms() const {
    return state_->time_us / 1000;
}

bool Window::is_down(std::string_view input) const {
    // A quarter of the range is a stick's dead zone.
    return pressure_256(input) >= 64;
}

bool Window::was_pressed(std::string_view input) const {
    return press_count(input) > 0;
}

bool Window::was_released(std::string_view input) const {
    const std::vector<Input>& released = state_->released;
    return std::find(released.begin(), released.end(), named(input)) != released.end();
}

const std::string& Window::typed() const {
    return state_->typed;
}

std::int32_t Window::press_count(std::string_view input) const {
    const std::vector<Input>& pressed = state_->pressed;
    return static_cast<std::int32_t>(std::count(pressed.begin(), pressed.end(), named(input)));
}

std::int32_t Window::pressure_256(std::string_view input) const {
    const auto found = state_->held.find(named(input));
    return found == state_->held.end() ? 0 : found->second * 256 / kFullAxis;
}

PixelPosition Window::mouse() const {
    return state_->mouse;
}

PixelPosition Window::mouse_motion() const {
    return state_->motion;
}

void Window::capture_mouse(bool is_captured) {
    state_->platform.capture_mouse(is_captured);
}

void Window::set_full_screen(bool is_full) {
    state_->settings.is_full_screen = is_full;
    state_->platform.change_window(state_->settings);
}

void Window::set_rate(std::int32_t pictures_per_second) {
    state_->settings.frames_per_second = std::max(pictures_per_second, 0);
    state_->platform.change_window(state_->settings);
}

void Window::set_icon(const Picture& picture) {
    std::vector<std::uint8_t> rgba;
    for (const std::uint8_t pixel : checked(picture).pixels) {
        const Rgb8 colour = item(palette.colours, pixel);
        const std::uint8_t alpha = pixel == kTransparent ? 0 : 255;
        rgba.insert(rgba.end(), {colour.red, colour.green, colour.blue, alpha});
    }
    state_->platform.set_icon(rgba, {picture.width_px, picture.height_px});
}

}  // namespace oblong
