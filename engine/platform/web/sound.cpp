#include <emscripten.h>

#include <array>
#include <stdexcept>

#include "engine/platform/web/web.h"
#include "engine/sound/mixer.h"

namespace oblong {
namespace {

using Samples = std::array<std::int16_t, 2048>;
using Mix = void (*)(Mixer* mixer, std::int16_t* samples, int frames);

EM_JS(int, page_open_sound, (Mix mix, Mixer* mixer, std::int16_t* samples), {
    try {
        const mixed = wasmTable.get(mix);
        Page.openSound(function(frames) {
            mixed(mixer, samples, frames);
            return HEAP16.subarray(samples >> 1, (samples >> 1) + 2 * frames);
        });
        return 1;
    } catch (error) {
        return 0;
    }
});
EM_JS(void, page_close_sound, (), { Page.closeSound(); });

class PageSound final : public Mixer {
  public:
    PageSound() {
        const Mix mix = [](Mixer* mixer, std::int16_t* samples, int frames) {
            mixer->mix({samples, static_cast<std::size_t>(frames) * 2});
        };
        if (page_open_sound(mix, this, samples_.data()) == 0)
            throw std::runtime_error("no sound: the browser has no AudioContext for it");
    }
    ~PageSound() override { page_close_sound(); }

  private:
    Samples samples_{};
};

}  // namespace

std::unique_ptr<SoundOutput> open_page_sound() {
    return std::make_unique<PageSound>();
}

}  // namespace oblong
