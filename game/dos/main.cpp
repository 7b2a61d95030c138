// The game under DOS: OBLONG [NAME=VALUE ...], with options named as on the command line of other systems
// ("accuracy=1994"). Also replay=FILE; hashes=N, which draws N ticks of the walk as fast as possible and writes each
// tick's hash to the serial port, and with hold=1 shows the last picture until a key is pressed; and report=1, which
// writes the numbers of pictures shown and keys pressed there.
#include <malloc.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <memory>
#include <new>
#include <string>
#include <utility>
#include <vector>

#include "engine/base/checksum.h"
#include "engine/base/text.h"
#include "engine/io/files.h"
#include "engine/platform/dos/calls.h"
#include "engine/platform/dos/pc.h"
#include "engine/platform/dos/sound_blaster.h"
#include "engine/programs/arguments.h"
#include "game/dos/prepared_game.h"
#include "game/options/preference_table.h"
#include "game/program/program.h"
#include "game/simulation/step.h"
#include "tools/gallery/program/gallery_screen.h"

namespace oblong {
namespace {

constexpr const char* kAssets = "/assets";
constexpr const char* kData = "/oblong";  // exists if DOS stores it

struct Arguments {
    Options options;
    std::size_t hashed_ticks = 0;
    bool holds = false, reports = false;
};

// Writes each picture and key press to the serial port, so that a test does not depend on time.
class ReportingPc : public dos::Pc {
  public:
    explicit ReportingPc(bool reports) : reports_(reports) {}
    void present(Framebuffer picture, const Palette& palette, const PresentRect& shown) override {
        Pc::present(picture, palette, shown);
        if (reports_) std::fprintf(stderr, "shown %u\n", ++shown_);
    }
    PlatformInput poll() override {
        PlatformInput input = Pc::poll();
        for (const InputEvent& event : input.events)
            if (reports_ && event.kind == InputEvent::Kind::Press) std::fprintf(stderr, "pressed %u\n", ++pressed_);
        return input;
    }

  private:
    bool reports_;
    unsigned shown_ = 0, pressed_ = 0;
};

std::size_t whole_number(const std::string& name, const std::string& text) {
    if (text.empty() || text.size() > 6 || text.find_first_not_of("0123456789") != std::string::npos)
        throw UsageError(name + ": '" + text + "', expected a number");
    return static_cast<std::size_t>(std::stoi(text));
}

void take(const std::string& name, const std::string& value, Arguments& arguments) {
    Preferences& preferences = arguments.options.preferences;
    if (name == "hashes") {
        arguments.hashed_ticks = whole_number(name, value);
        return;
    }
    if (name == "hold") {
        arguments.holds = value == "1";
        return;
    }
    if (name == "report") {
        arguments.reports = value == "1";
        return;
    }
    if (name == "replay") {
        arguments.options.replay = value;
        return;
    }
    for (const char* const chosen : {"accuracy", "view-size", "double-columns"})
        if (name == chosen) arguments.options.chooses_view = false;
    for (const Preference& preference : all_preferences())
        if (preference.name == name) return preference.parse(preferences, value);
    throw UsageError("'" + name + "', expected NAME=VALUE of an option that oblong --help lists, as accuracy=1994");
}

// DOS has no small letters of its own.
Arguments read_arguments(int count, char** words) {
    Arguments arguments;
    take("accuracy", "pixel", arguments);  // what a 486 affords (tools/accuracy/README.md)
    arguments.options.chooses_view = true;
    for (int i = 1; i < count; ++i) {
        const std::string word = lower_case(words[i]);
        const std::size_t equals = std::min(word.find('='), word.size());
        take(word.substr(0, equals), word.substr(std::min(equals + 1, word.size())), arguments);
    }
    check_view(arguments.options.preferences.mode, arguments.options.preferences.field_of_view);
    arguments.options.shows_title = arguments.options.replay.empty();
    if (std::filesystem::is_directory(kData)) arguments.options.folders.data = kData;
    return arguments;
}

void print_memory() {
    dos::MemoryState memory;
    call(dos::Call::Memory, &memory);
    std::fprintf(stderr, "memory: %u of %u KB, stack: %u of %u KB, %u instructions emulated\n", memory.most / 1024,
                 memory.size / 1024, memory.stack / 1024, dos::kStackSize / 1024, memory.emulated);
}

// With less memory the walk would need what sounds take.
bool has_memory_for_sounds() {
    constexpr std::uint32_t kWithSounds = 10752 * 1024;
    dos::MemoryState memory;
    call(dos::Call::Memory, &memory);
    if (memory.size < kWithSounds) std::fprintf(stderr, "oblong: no sounds, which need 12 MB\n");
    return memory.size >= kWithSounds;
}

std::string asset(const char* name) {
    return std::string(kAssets) + "/" + name;
}

// The memory of a sound file is free once it has been read.
void free_sounds() {
    for (const auto& entry : std::filesystem::directory_iterator(asset("sounds"))) read_file(entry.path().string());
}

// As the build has prepared it: there is no reader of OBJ and PNG files, no music, and the rest takes seconds on a 486.
GameData load_museum(const LevelFiles& files, bool has_sounds) {
    GameData data;
    data.level_file = asset(kDemoLevelFile);
    data.palette = read_parsed(files.game->palette, read_palette);
    read_parsed(data.level_file,
                [&](std::span<const std::uint8_t> bytes) { return decode_prepared_game(bytes, data); });
    std::erase_if(data.level.entities.front().pairs, [](const auto& pair) { return pair.first == "music"; });
    if (has_sounds)
        data.sounds = read_level_sounds(data.level, {kAssets});
    else
        data.sounds.by_entity.resize(data.level.entities.size(), LevelSounds::kNone);
    data.effects = read_level_effects(data.level);
    return data;
}

LevelFiles museum_files(bool has_sounds) {
    return {"",
            "",
            kAssets,
            "",
            {},
            std::make_shared<const GameDefinition>(read_parsed(asset("game"), decode_definition)),
            [has_sounds](const LevelFiles& files) { return load_museum(files, has_sounds); }};
}

// For tests: the hash of the state after each tick, and of its picture.
void print_hashes(const Options& options, std::size_t ticks, dos::Pc& pc) {
    const auto now_ms = [&pc] { return static_cast<unsigned>(pc.now_us() / 1000); };
    const LoadedLevel loaded(museum_files(false));
    const Demo demo = read_parsed(asset("walk.demo"), decode_demo);
    std::fprintf(stderr, "read at %u ms\n", now_ms());
    GameRenderer renderer(loaded.data, loaded.level, options.preferences.mode, nullptr, options.preferences);
    const Settings settings = settings_of(options.preferences);
    GameState state = start_of(loaded.level);
    std::uint64_t drawing_us = 0;
    ticks = std::min(ticks, demo.ticks.size());
    for (std::size_t tick = 0; tick < ticks; ++tick) {
        step(loaded.level, state, demo.ticks[tick].input);
        const InterpolatedState frame{state, state, 0};
        const std::uint64_t began_us = pc.now_us();
        renderer.draw({frame, camera_at(frame, {}, options.preferences.field_of_view)}, settings);
        drawing_us += pc.now_us() - began_us;
        const Framebuffer canvas = renderer.canvas();
        pc.present(canvas, loaded.data.palette, {});
        if (tick == 0) std::fprintf(stderr, "first picture at %u ms\n", now_ms());
        Fnv1a hash;
        for (std::int32_t y = 0; y < canvas.height_px; ++y)
            for (std::int32_t x = 0; x < canvas.width_px; ++x) hash.add(canvas.row(y)[x]);
        std::fprintf(stderr, "tick %u state %016llx picture %016llx\n", static_cast<unsigned>(tick + 1),
                     static_cast<unsigned long long>(hash_of(state)), static_cast<unsigned long long>(hash.value()));
    }
    std::fprintf(stderr, "%u pictures, %u us each\n", static_cast<unsigned>(ticks),
                 static_cast<unsigned>(drawing_us / std::max<std::size_t>(ticks, 1)));
}

void wait_for_key(dos::Pc& pc) {
    constexpr std::int32_t kSecond_ms = 1000;
    while (pc.poll().events.empty()) pc.wait_for_input(kSecond_ms);
}

void play(const Options& options, dos::Pc& pc) {
    const OpenSound open_sound = has_memory_for_sounds() ? dos::sound_of_card() : nullptr;
    if (!open_sound) free_sounds();
    PreferencesStore store;
    store.begin_with(options.preferences);
    ProgramFiles files = load_program_files(options, museum_files(open_sound != nullptr));
    Program program(options, std::move(files), store, pc, {.open_sound = open_sound, .open_gallery = open_gallery});
    try {
        program.run();
    } catch (const std::bad_alloc&) {  // the unfinished picture has freed what saving needs
        program.keep();
        throw;
    }
}

int run(int count, char** words) {
    // Memory is scarce, so large freed blocks are returned at once, and the heap grows by as little as is needed.
    mallopt(M_MMAP_THRESHOLD, 64 * 1024);
    mallopt(M_TRIM_THRESHOLD, 64 * 1024);
    mallopt(M_TOP_PAD, 16 * 1024);
    return run_program("oblong", [&] {
        const Arguments arguments = read_arguments(count, words);
        ReportingPc pc(arguments.reports);
        if (arguments.hashed_ticks > 0) {
            print_hashes(arguments.options, arguments.hashed_ticks, pc);
            if (arguments.holds) wait_for_key(pc);
        } else {
            play(arguments.options, pc);
        }
        if (arguments.hashed_ticks > 0 || arguments.reports)
            print_memory();
        else
            std::fprintf(stderr, "The museum is closed. Good night.\n");
    });
}

}  // namespace
}  // namespace oblong

// Replaces the library's own, which would add a demangler.
void __gnu_cxx::__verbose_terminate_handler() {
    std::abort();
}

int main(int argc, char** argv) {
    return oblong::run(argc, argv);
}
