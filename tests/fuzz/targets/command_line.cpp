// The game's command line, an argument a line: read, or refused with one line that names the program.

#include <stdio.h>
#include <stdlib.h>

#include <iostream>
#include <sstream>

#include "engine/platform/input.h"
#include "game/options/options.h"
#include "game/options/preference_table.h"
#include "tests/fuzz/common/fuzz.h"

namespace oblong::fuzz {
namespace {

constexpr const char* kOptions[] = {"--record",  "--replay", "--timedemo",  "--route",   "--headless", "--out",
                                    "--map",     "--game",   "--palette",   "--models",  "--title",    "--gallery",
                                    "--log",     "--lines",  "--automap",   "--threads", "--window",   "--wireframe",
                                    "--config",  "--dial",   "--error-box", "--help",    "--version",  "--portable",
                                    "level.bsp", "-",        "--",          "--no-vsync"};
constexpr const char* kValues[] = {"off",  "on",    "north",   "640x480",   "0x0", "100000x1",
                                   "4:3",  "1991",  "bounded", "texel=0.5", "",    "/dev/null",
                                   "time", "naive", "all",     "a=b",       "=",   "mip-bias=-1"};

std::string some_line(std::minstd_rand& random) {
    const KeptValue& value = *one_of(all_kept_values(), random);
    const std::string name = below(2, random) ? one_of(kOptions, random) : "--" + value.name;
    const std::string its_value = below(3, random) == 0   ? value.text({})
                                  : below(2, random) == 0 ? std::to_string(odd_number(random))
                                                          : one_of(kValues, random);
    return name + (below(2, random) ? "\n" : "=") + its_value + "\n";
}

std::vector<std::string> lines_of(const std::string& text) {
    std::vector<std::string> lines;
    for (std::size_t begin = 0; begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(std::string_view("\n\0", 2), begin), text.size());
        lines.push_back(text.substr(begin, end - begin));
        begin = end + 1;
    }
    return lines;
}

// What is said on standard error while it lives, by C's stream and by C++'s; and nothing on standard output.
class Said {
  public:
    Said() : file_(open_memstream(&text_, &size_)) {
        std::swap(stderr, file_);
        output_ = std::cout.rdbuf(nullptr);
        error_ = std::cerr.rdbuf(&cpp_text_);
    }
    Said(const Said&) = delete;
    ~Said() { free(text_); }

    std::string end() {
        std::swap(stderr, file_);
        fclose(file_);
        std::cout.rdbuf(output_);
        std::cerr.rdbuf(error_);
        return std::string(text_, size_) + cpp_text_.str();
    }

  private:
    char* text_ = nullptr;
    std::size_t size_ = 0;
    FILE* file_;
    std::stringbuf cpp_text_;
    std::streambuf *output_, *error_;
};

}  // namespace

void mutate(Bytes& input, std::minstd_rand& random) {
    if (below(4, random) == 0) return mutate_bytes(input, 16);
    std::string text = text_of(input);
    const std::size_t line_end = text.find('\n', below(text.size(), random));
    text.insert(line_end == std::string::npos ? 0 : line_end + 1, some_line(random));
    set_text(input, text);
}

void run(Input input) {
    constexpr std::size_t kMost = 512;  // a longer one takes longer and does nothing else
    static const int no_home = setenv("HOME", "/nonexistent", 1) + setenv("XDG_CONFIG_HOME", "/nonexistent", 1) +
                               setenv("XDG_DATA_HOME", "/nonexistent", 1);
    expect(no_home == 0, "a player without files");
    const std::vector<std::string> lines = lines_of(text_of(input.first(std::min(input.size(), kMost))));
    std::vector<const char*> arguments{"oblong"};
    for (const std::string& line : lines) arguments.push_back(line.c_str());
    bool has_run = false;
    Said said;
    const int code = run_with_options(static_cast<int>(arguments.size()), arguments.data(),
                                      [&](const Options&, PreferencesStore&) { has_run = true; });
    const std::string text = said.end();
    expect(code == 0 || (code == 2 && !has_run) || code == 1,
           "an exit code for what happened, not " + std::to_string(code));
    expect(code == 0 || text.starts_with("oblong: "), "a line with the program's name, not " + text);
    note_reached(text);
}

}  // namespace oblong::fuzz
