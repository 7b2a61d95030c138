// The examples' page: runs the program that the first argument names. Arguments NAME=VALUE before it set the
// environment, as in a shell.
#include <cstdio>
#include <cstdlib>
#include <iterator>
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
    if (std::size(kExamples) == 1) return kExamples[0].run(argc, argv);
    const std::string name = argc > 1 ? argv[1] : "";
    for (const Example& example : kExamples)
        if (name == example.name) return example.run(argc - 1, argv + 1);
    if (!name.empty())
        std::fprintf(stderr, "'%s' is no example, expected one that the page without '?' lists\n", name.c_str());
    return 0;
}
