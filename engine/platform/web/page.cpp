#include <emscripten.h>

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "engine/platform/crt_mask.h"
#include "engine/platform/web/web.h"

namespace oblong {
namespace {

/// The page's state, as page.js writes it.
struct PageState {
    std::int32_t has_focus, is_hidden, changes_full_screen;
    std::int32_t has_pointer, pointer_x_px, pointer_y_px, has_moved, is_pressed;
    std::int32_t event_count;
};

/// An InputEvent, as page.js writes it.
struct PageEvent {
    std::int32_t kind, device, code, x, y;
};

EM_JS(void, page_state, (PageState * state), { Page.state(HEAP32, state >> 2); });
EM_JS(void, page_events, (PageEvent * events), { Page.takeEvents(HEAP32, events >> 2); });
EM_JS(void, page_text, (char* text, int most), { stringToUTF8(Page.takeText(most), text, 4 * most + 1); });
EM_JS(void, page_size, (std::int32_t * size), { HEAP32.set([ Page.canvas.width, Page.canvas.height ], size >> 2); });
EM_JS(int, page_take_lost, (), { return Page.takeLost() ? 1 : 0; });
EM_JS(void, page_title, (const char* title), { document.title = UTF8ToString(title); });
EM_JS(void, page_capture, (int is_captured), { Page.capture(is_captured != 0); });
EM_JS(int, page_letter, (int key), { return Page.letter(key); });
// Whether touch is in use.
EM_JS(int, page_button, (int key, char* name, int size), {
    stringToUTF8(Page.buttonOf(key), name, size);
    return Page.hasTouch;
});
EM_JS(void, page_fill_screen, (int fills), { Page.fillScreen(fills != 0); });
EM_JS(void, page_mask, (const std::uint32_t* argb, int width, int height),
      { Page.screen.setMask(HEAPU8.subarray(argb, argb + 4 * width * height), width, height); });
EM_JS(void, page_present, (const std::uint32_t* rgba, int width, int height, const PresentRect* shown), {
    Page.screen.present(HEAPU8.subarray(rgba, rgba + 4 * width * height), width, height,
                        HEAP32.subarray(shown >> 2, (shown >> 2) + 6), HEAPU8[shown + 24] != 0,
                        HEAPU8[shown + 32] != 0);
});
EM_JS(void, page_wait, (), { return new Promise(requestAnimationFrame); });
static_assert(offsetof(PresentRect, is_blended) == 24 && offsetof(PresentRect, has_crt_look) == 32);

class PagePlatform final : public Platform {
  public:
    explicit PagePlatform(bool waits) : waits_(waits) {}
    bool is_open() const override { return true; }
    PlatformInput poll() override;
    std::uint64_t now_us() override { return static_cast<std::uint64_t>(emscripten_get_now() * 1000); }
    WindowSize window_size() const override;
    void set_title(const char* title) override { page_title(title); }
    void capture_mouse(bool is_captured) override { page_capture(is_captured); }
    std::string local_name_of(Input input) const override;
    void change_window(const WindowSettings& settings) override;
    bool wait_for_input(std::int32_t) override { return page_take_lost() != 0; }  // the browser waits
    void present(Framebuffer picture, const Palette& palette, const PresentRect& shown) override;

  private:
    const bool waits_;
    bool is_full_screen_ = false;
    std::array<std::int32_t, 3> mask_{};  // width, height, rows
    std::vector<std::uint32_t> rgba_;     // of the picture: bytes red, green, blue, 255
};

PlatformInput PagePlatform::poll() {
    PageState state{};
    page_state(&state);
    std::vector<PageEvent> events(static_cast<std::size_t>(state.event_count));
    page_events(events.data());
    PlatformInput input;
    for (const PageEvent& event : events) {
        const Input device{static_cast<Device>(event.device), static_cast<std::uint16_t>(event.code)};
        const auto kind = static_cast<InputEvent::Kind>(event.kind);
        (is_of_pad(device) && device.code >= 256 ? input.pad_events : input.events)
            .push_back({kind, device, event.x, event.y});
    }
    std::array<char, 4 * 64 + 1> text{};
    page_text(text.data(), 64);
    input.text = text.data();
    input.has_focus = state.has_focus != 0;
    input.is_minimised = state.is_hidden != 0;
    input.changes_full_screen = state.changes_full_screen != 0;
    if (state.has_pointer != 0)
        input.pointer = Pointer{state.pointer_x_px, state.pointer_y_px, state.has_moved != 0, state.is_pressed != 0};
    return input;
}

WindowSize PagePlatform::window_size() const {
    std::array<std::int32_t, 2> size{};
    page_size(size.data());
    return {size[0], size[1]};
}

// The name of the button on the screen, or the letter on the user's keyboard if the browser reports it.
std::string PagePlatform::local_name_of(Input input) const {
    std::array<char, 16> button{};
    if (input.device != Device::Key) return name_of(input);
    if (page_button(input.code, button.data(), std::ssize(button)) != 0) return button.data();
    const std::string name = name_of_letter(page_letter(input.code));
    return name.empty() ? name_of(input) : name;
}

void PagePlatform::change_window(const WindowSettings& settings) {
    if (std::exchange(is_full_screen_, settings.is_full_screen) != settings.is_full_screen)
        page_fill_screen(settings.is_full_screen);
}

void PagePlatform::present(Framebuffer picture, const Palette& palette, const PresentRect& shown) {
    const std::array<std::int32_t, 3> mask{shown.width_px, shown.height_px, picture.height_px};
    if (shown.has_crt_look && shown.width_px > 0 && std::exchange(mask_, mask) != mask)
        page_mask(make_crt_mask(mask[0], mask[1], mask[2]).data(), mask[0], mask[1]);
    std::array<std::uint32_t, 256> rgba{};
    std::transform(palette.colours.begin(), palette.colours.end(), rgba.begin(), [](Rgb8 colour) {
        return 0xFF000000u | std::uint32_t{colour.blue} << 16 | std::uint32_t{colour.green} << 8 | colour.red;
    });
    rgba_.resize(static_cast<std::size_t>(picture.width_px) * static_cast<std::size_t>(picture.height_px));
    std::uint32_t* to = rgba_.data();
    for (std::int32_t y = 0; y < picture.height_px; ++y)
        to = std::transform(picture.row(y), picture.row(y) + picture.width_px, to,
                            [&](std::uint8_t colour) { return rgba[colour]; });
    page_present(rgba_.data(), picture.width_px, picture.height_px, &shown);
    if (waits_) page_wait();
}

}  // namespace

std::unique_ptr<Platform> open_page(bool waits) {
    return std::make_unique<PagePlatform>(waits);
}

}  // namespace oblong
