#include <algorithm>
#include <array>
#include <chrono>
#include <clocale>
#include <mutex>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>
#include <vector>

#include "engine/platform/sdl/crt_look.h"
#include "engine/platform/sdl/frame_pacing.h"
#include "engine/platform/sdl/input.h"
#include "engine/platform/sdl/owned.h"
#include "engine/platform/sdl/sdl.h"

namespace oblong {
namespace {

[[noreturn]] void fail(const char* what) {
    throw std::runtime_error(std::string(what) + ": " + SDL_GetError());
}

// SDL falls back to drivers without a display. They are used only if SDL_VIDEODRIVER is exactly their name: not if it
// is empty, nor at the end of a list.
bool shows_nothing() {
    const std::string_view driver = SDL_GetCurrentVideoDriver();
    const char* const wanted = SDL_getenv("SDL_VIDEODRIVER");
    return (driver == "offscreen" || driver == "dummy") && (wanted == nullptr || driver != wanted);
}

// SDL's windows and their events are the process's, and work on one thread: that of the first open window.
struct WindowsThread {
    std::mutex mutex;
    std::thread::id thread;
    int windows = 0;
};
WindowsThread& windows_thread() {
    static WindowsThread shared;
    return shared;
}

struct Video {
    Video() {
        WindowsThread& shared = windows_thread();
        const std::lock_guard lock(shared.mutex);
        if (shared.windows > 0 && shared.thread != thread)
            throw std::runtime_error("window: another is open on another thread, expected all on one");
        if (SDL_InitSubSystem(SDL_INIT_VIDEO) != 0) fail("no display");
        if (shows_nothing()) {
            SDL_QuitSubSystem(SDL_INIT_VIDEO);
            throw std::runtime_error("no display: SDL found no video driver that opens a window");
        }
        shared.thread = thread;
        ++shared.windows;
    }
    ~Video() {
        SDL_QuitSubSystem(SDL_INIT_VIDEO);
        WindowsThread& shared = windows_thread();
        const std::lock_guard lock(shared.mutex);
        --shared.windows;
    }
    Video(const Video&) = delete;
    Video& operator=(const Video&) = delete;

    void check_thread() const {
        if (thread != std::this_thread::get_id())
            throw std::runtime_error("window: used on another thread than it was opened on, expected that");
    }

    const std::thread::id thread = std::this_thread::get_id();
};

// The largest whole multiple of 320x240 that leaves the desktop's bars free.
WindowSize comfortable_size() {
    SDL_Rect desktop{0, 0, 1280, 960};
    SDL_GetDisplayUsableBounds(0, &desktop);
    const int times = std::clamp(std::min(desktop.w / 320, (desktop.h - 40) / 240), 1, 5);
    return {320 * times, 240 * times};
}

// libX11 converts titles by the locale: in that of C, a title with a dash or some others of Unicode's letters is
// refused; in that of UTF-8, tools that know only the old property WM_NAME can't read any.
void set_title_of(SDL_Window* window, const char* title) {
    const std::string_view letters = title;
    if (std::all_of(letters.begin(), letters.end(), [](char letter) { return (letter & 0x80) == 0; }))
        return SDL_SetWindowTitle(window, title);
    const std::string before = std::setlocale(LC_CTYPE, nullptr);
    std::setlocale(LC_CTYPE, "C.UTF-8");
    SDL_SetWindowTitle(window, title);
    std::setlocale(LC_CTYPE, before.c_str());
}

Owned<SDL_Window> make_window(const char* title, WindowSize size) {
    if (size == WindowSize{}) size = comfortable_size();
    Owned<SDL_Window> window(SDL_CreateWindow(title, SDL_WINDOWPOS_CENTERED, SDL_WINDOWPOS_CENTERED, size.width_px,
                                              size.height_px, SDL_WINDOW_RESIZABLE | SDL_WINDOW_ALLOW_HIGHDPI));
    if (!window) fail("no window");
    set_title_of(window.get(), title);
    return window;
}

// A hardware renderer if there is one, else SDL's software renderer.
Owned<SDL_Renderer> make_renderer(SDL_Window* window) {
    constexpr std::array<std::uint32_t, 3> wishes{SDL_RENDERER_ACCELERATED | SDL_RENDERER_PRESENTVSYNC,
                                                  SDL_RENDERER_ACCELERATED, SDL_RENDERER_SOFTWARE};
    for (const std::uint32_t wish : wishes)
        if (Owned<SDL_Renderer> renderer{SDL_CreateRenderer(window, -1, wish | SDL_RENDERER_TARGETTEXTURE)})
            return renderer;
    fail("no renderer");
}

// The most frames a second for a window that waits for its display: the limit if presenting does not wait although it
// should. It is an eighth above the display's rate, so that a display of 59.94 Hz, reported as 59, is not slowed down.
std::int32_t display_limit(SDL_Window* window) {
    constexpr int kUnknownRate = 128;
    SDL_DisplayMode mode{};
    SDL_GetCurrentDisplayMode(std::max(SDL_GetWindowDisplayIndex(window), 0), &mode);
    const int rate = mode.refresh_rate > 0 ? mode.refresh_rate : kUnknownRate;
    return rate + rate / 8;
}

void write_colours(Framebuffer picture, const Palette& palette, SDL_Texture* texture) {
    std::array<std::uint32_t, 256> argb{};
    for (std::size_t i = 0; i < argb.size(); ++i) {
        const Rgb8 colour = palette.colours[i];
        argb[i] = 0xff000000u | std::uint32_t{colour.red} << 16 | std::uint32_t{colour.green} << 8 | colour.blue;
    }
    void* pixels = nullptr;
    int pitch = 0;
    if (SDL_LockTexture(texture, nullptr, &pixels, &pitch) != 0) return;
    for (std::int32_t y = 0; y < picture.height_px; ++y) {
        auto* to = reinterpret_cast<std::uint32_t*>(static_cast<std::uint8_t*>(pixels) + std::ptrdiff_t{pitch} * y);
        std::transform(picture.row(y), picture.row(y) + picture.width_px, to, [&](std::uint8_t i) { return argb[i]; });
    }
    SDL_UnlockTexture(texture);
}

class SdlPlatform final : public Platform {
  public:
    SdlPlatform(const char* title, WindowSize size)
        : window_(make_window(title, size)), renderer_(make_renderer(window_.get())), input_(window_.get()) {}

    bool is_open() const override { return !input_.is_closed(); }
    PlatformInput poll() override {
        video_.check_thread();
        return input_.poll();
    }
    std::uint64_t now_us() override;
    WindowSize window_size() const override;
    void set_title(const char* title) override { set_title_of(window_.get(), title); }
    void set_icon(std::span<const std::uint8_t> rgba, WindowSize size) override;
    void capture_mouse(bool is_captured) override { input_.capture_mouse(is_captured); }
    std::string local_name_of(Input input) const override { return input_.local_name_of(input); }
    void change_window(const WindowSettings& settings) override;
    bool wait_for_input(std::int32_t timeout_ms) override;
    void present(Framebuffer picture, const Palette& palette, const PresentRect& shown) override;

  private:
    bool is_minimised() const;
    void draw_picture(Framebuffer picture, const Palette& palette, const PresentRect& shown);
    SDL_Texture* fitted(Owned<SDL_Texture>& texture, int access, WindowSize size, SDL_ScaleMode scale_mode);
    SDL_Texture* upscaled(SDL_Texture* picture, WindowSize size);
    void draw_crt_look(const PresentRect& shown);
    void wait_until_due();

    Video video_;  // first: it outlives the rest
    Owned<SDL_Window> window_;
    Owned<SDL_Renderer> renderer_;
    Owned<SDL_Texture> picture_, upscaled_;
    std::unique_ptr<CrtLook> crt_look_;  // only while it is on
    WindowSettings settings_;
    FramePacing pacing_;
    SdlInput input_;
};

std::uint64_t SdlPlatform::now_us() {
    const std::uint64_t counter = SDL_GetPerformanceCounter(), rate = SDL_GetPerformanceFrequency();
    return counter / rate * 1'000'000 + counter % rate * 1'000'000 / rate;
}

void SdlPlatform::set_icon(std::span<const std::uint8_t> rgba, WindowSize size) {
    std::vector<std::uint8_t> pixels(rgba.begin(), rgba.end());  // SDL needs a writable buffer
    const Owned<SDL_Surface> surface(SDL_CreateRGBSurfaceWithFormatFrom(pixels.data(), size.width_px, size.height_px,
                                                                        32, size.width_px * 4, SDL_PIXELFORMAT_RGBA32));
    if (surface) SDL_SetWindowIcon(window_.get(), surface.get());
}

WindowSize SdlPlatform::window_size() const {
    WindowSize size;
    SDL_GetRendererOutputSize(renderer_.get(), &size.width_px, &size.height_px);
    return size;
}

// Returns `texture`, remade if its size differs.
SDL_Texture* SdlPlatform::fitted(Owned<SDL_Texture>& texture, int access, WindowSize size, SDL_ScaleMode scale_mode) {
    WindowSize is;
    if (texture) SDL_QueryTexture(texture.get(), nullptr, nullptr, &is.width_px, &is.height_px);
    if (is == size) return texture.get();
    texture.reset(SDL_CreateTexture(renderer_.get(), SDL_PIXELFORMAT_ARGB8888, access, size.width_px, size.height_px));
    if (texture) SDL_SetTextureScaleMode(texture.get(), scale_mode);
    return texture.get();
}

// The picture enlarged by whole multiples, to be scaled down with blending; the picture itself if the renderer fails.
SDL_Texture* SdlPlatform::upscaled(SDL_Texture* picture, WindowSize size) {
    SDL_Texture* target = fitted(upscaled_, SDL_TEXTUREACCESS_TARGET, size, SDL_ScaleModeLinear);
    if (target == nullptr || SDL_SetRenderTarget(renderer_.get(), target) != 0) return picture;
    SDL_RenderCopy(renderer_.get(), picture, nullptr, nullptr);
    SDL_SetRenderTarget(renderer_.get(), nullptr);
    return target;
}

void SdlPlatform::change_window(const WindowSettings& settings) {
    if (settings.is_full_screen != settings_.is_full_screen)
        SDL_SetWindowFullscreen(window_.get(), settings.is_full_screen ? SDL_WINDOW_FULLSCREEN_DESKTOP : 0);
    if (settings.waits_for_display != settings_.waits_for_display)
        SDL_RenderSetVSync(renderer_.get(), settings.waits_for_display ? 1 : 0);
    settings_ = settings;
}

// With a gamepad, SDL_WaitEventTimeout() polls every millisecond: 1.7 % of a processor.
bool SdlPlatform::wait_for_input(std::int32_t timeout_ms) {
    if (SDL_NumJoysticks() <= 0) return SDL_WaitEventTimeout(nullptr, timeout_ms) == 1;
    constexpr std::int32_t kStep_ms = 15;
    SDL_PumpEvents();
    for (std::int32_t waited_ms = 0; waited_ms < timeout_ms; waited_ms += kStep_ms) {
        if (SDL_HasEvents(SDL_FIRSTEVENT, SDL_LASTEVENT) == SDL_TRUE) return true;
        SDL_Delay(static_cast<std::uint32_t>(std::min(kStep_ms, timeout_ms - waited_ms)));
        SDL_PumpEvents();
    }
    return false;
}

bool SdlPlatform::is_minimised() const {
    return (SDL_GetWindowFlags(window_.get()) & (SDL_WINDOW_MINIMIZED | SDL_WINDOW_HIDDEN)) != 0;
}

void SdlPlatform::present(Framebuffer picture, const Palette& palette, const PresentRect& shown) {
    constexpr std::int32_t kUnseenFrame_ms = 200;  // less than the pause that TickClock counts
    video_.check_thread();
    if (is_minimised()) {
        wait_for_input(kUnseenFrame_ms);
        return;
    }
    draw_picture(picture, palette, shown);
    wait_until_due();
    SDL_RenderPresent(renderer_.get());
}

void SdlPlatform::draw_picture(Framebuffer picture, const Palette& palette, const PresentRect& shown) {
    if (input_.take_textures_lost()) {
        picture_.reset();
        upscaled_.reset();
        crt_look_.reset();
    }
    SDL_Texture* source =
        fitted(picture_, SDL_TEXTUREACCESS_STREAMING, {picture.width_px, picture.height_px}, SDL_ScaleModeNearest);
    if (source == nullptr) fail("no texture");
    write_colours(picture, palette, source);
    if (shown.is_blended)
        source = upscaled(source, {picture.width_px * shown.upscale_x, picture.height_px * shown.upscale_y});

    SDL_SetRenderDrawColor(renderer_.get(), 0, 0, 0, 255);
    SDL_RenderClear(renderer_.get());
    const SDL_Rect target{shown.x_px, shown.y_px, shown.width_px, shown.height_px};
    if (target.w > 0) SDL_RenderCopy(renderer_.get(), source, nullptr, &target);
    draw_crt_look(shown);
}

void SdlPlatform::draw_crt_look(const PresentRect& shown) {
    if (!shown.has_crt_look) return crt_look_.reset();
    if (!crt_look_) crt_look_ = std::make_unique<CrtLook>(renderer_.get());
    crt_look_->draw_over(picture_.get(), shown);
}

void SdlPlatform::wait_until_due() {
    std::int32_t most = settings_.frames_per_second;
    if (settings_.waits_for_display) {
        const std::int32_t limit = display_limit(window_.get());
        most = most == 0 ? limit : std::min(most, limit);
    }
    std::this_thread::sleep_for(std::chrono::microseconds(pacing_.next_wait_us(now_us(), most)));
}

}  // namespace

std::unique_ptr<Platform> open_window(const char* title, WindowSize size) {
    return std::make_unique<SdlPlatform>(title, size);
}

}  // namespace oblong
