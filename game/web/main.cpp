#include <emscripten.h>

#include <memory>

#include "engine/platform/web/web.h"
#include "engine/programs/arguments.h"
#include "game/lab/error_meter.h"
#include "game/options/options.h"
#include "game/program/program.h"
#include "tools/gallery/program/gallery_screen.h"

namespace oblong {
namespace {

constexpr const char* kAssets = "/assets";

using Keep = void (*)(void* page);

EM_JS(void, page_when_hidden, (Keep keep, void* page), {
    const called = wasmTable.get(keep);
    Page.whenHidden = function() {
        called(page);
    };
});
EM_JS(int, page_without_address, (), { return Page.withoutAddress(); });
EM_JS(void, page_end, (const char* text), { Page.end(UTF8ToString(text)); });

/// The browser calls the game for each picture, so this outlives main().
struct PageGame {
    Options options;
    PreferencesStore store;
    std::unique_ptr<Platform> platform = open_page();
    Program program{options, load_program_files(options, kAssets), store, *platform,
                    ProgramParts{nullptr, open_page_sound, open_reference_meter, open_gallery}};
};

void step(void* page) {
    bool goes_on = false;
    const int code = run_program("oblong", [&] { goes_on = static_cast<PageGame*>(page)->program.step(); });
    if (goes_on) return;
    emscripten_cancel_main_loop();
    page_end(code == 0 ? "The game has ended." : "");
}

// A hidden tab may be closed without notice, so the walk is saved. A step opens the menu.
void keep(void* page) {
    Program& program = static_cast<PageGame*>(page)->program;
    run_program("oblong", [&] {
        if (program.step()) program.keep();
    });
}

void run_game(const Options& options, PreferencesStore& store) {
    if (options.headless_frames == 0) {
        PageGame* const page = new PageGame{options, store};
        page_when_hidden(keep, page);
        emscripten_set_main_loop_arg(step, page, 0, 0);
        return;
    }
    const auto platform = open_headless(options);
    Program(options, load_program_files(options, kAssets), store, *platform, {.open_gallery = open_gallery}).run();
    page_end("");
}

}  // namespace
}  // namespace oblong

int main(int argc, char** argv) {
    constexpr int kWrongUsage = 2;
    bool has_begun = false;  // not where the options are wrong, or ask for help alone
    const auto run = [&](const oblong::Options& options, oblong::PreferencesStore& store) {
        has_begun = true;
        oblong::run_game(options, store);
    };
    int code = oblong::run_with_options(argc, argv, run);
    if (!has_begun && (code == kWrongUsage || code == 0))
        code = oblong::run_with_options(oblong::page_without_address(), argv, run);
    if (code != 0) oblong::page_end("");
    return code;
}
