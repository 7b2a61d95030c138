// The examples' page: runs the program that the first argument names, or lists all. Arguments NAME=VALUE before it set
// the environment, as in a shell.
#include <emscripten.h>

#include <string>

#include "engine/platform/sdl/sdl.h"
#include "engine/platform/web/web.h"
#include "game/web/example_mains.h"

namespace {

struct Example {
    const char* name;
    int (*run)(int argc, char** argv);
};

constexpr Example kExamples[] = {
#include "game/web/example_table.h"
};

EM_JS(void, page_offer, (const char* name), {
    const link = document.createElement("a");
    link.textContent = UTF8ToString(name);
    link.href = "?" + link.textContent + " /assets";
    const list = document.getElementById("said");
    list.append(link, "\n");
    document.body.classList.remove("loads");
    Page.canvas.hidden = true;
});

}  // namespace

namespace oblong {

// The examples' window and sound, which are SDL's on other systems.
std::unique_ptr<Platform> open_window(const char* title, WindowSize) {
    std::unique_ptr<Platform> page = open_page(true);
    page->set_title(title);
    return page;
}

std::unique_ptr<SoundOutput> open_mixer() {
    return open_page_sound();
}

}  // namespace oblong

int main(int argc, char** argv) {
    for (; argc > 1 && std::string(argv[1]).find('=') != std::string::npos; --argc, ++argv) putenv(argv[1]);
    for (const Example& example : kExamples) {
        if (argc > 1 && std::string(argv[1]) == example.name) return example.run(argc - 1, argv + 1);
        if (argc == 1) page_offer(example.name);
    }
    return 0;
}
