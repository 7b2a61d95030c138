#include <algorithm>
#include <array>
#include <initializer_list>
#include <string>
#include <utility>

#include "tools/demo_level/sounds/grains.h"
#include "tools/demo_level/sounds/module_file.h"
#include "tools/demo_level/sounds/sounds.h"

// "After closing time": a museum at night, in D minor. Ten patterns of 64 rows; a row is 0.12 s.
namespace oblong::sound_source {
namespace {

using namespace synth;

// Notes from C-1. A module's C-2, its period 428, sounds at 8,287 Hz: a wave of 32 samples is C at 259 Hz.
enum Note : std::int32_t {
    C1,
    Cs1,
    D1,
    Ds1,
    E1,
    F1,
    Fs1,
    G1,
    Gs1,
    A1,
    As1,
    B1,
    C2,
    Cs2,
    D2,
    Ds2,
    E2,
    F2,
    Fs2,
    G2,
    Gs2,
    A2,
    As2,
    B2,
    C3,
    Cs3,
    D3,
    Ds3,
    E3,
    F3,
    Fs3,
    G3,
    Gs3,
    A3,
    As3,
    B3
};

enum Instrument : std::int32_t { Celesta = 1, Harp, Pad, Bass, Glass };

// The synthesiser's samples as those of a module: as many, of 8 bits.
std::vector<std::int8_t> eight_bits(const Samples& samples, bool is_loop) {
    std::vector<std::int8_t> wave;
    for (const std::int16_t sample : finished(samples, is_loop, 96))
        wave.push_back(static_cast<std::int8_t>(sample / 256));
    wave.resize(wave.size() / 2 * 2);
    return wave;
}

// Made at kRate_hz and played at 8,287 Hz, this frequency sounds as C at 259 Hz: 32 samples to the cycle.
constexpr std::int32_t kCycle = 32;
constexpr std::int64_t kC_chz = std::int64_t{kRate_hz} * 100 / kCycle;

// A note that rings out. Frequencies of modes are in thousandths of the note's.
ModuleSample ringing_note(const std::string& name, std::int32_t ms, std::initializer_list<Mode> modes) {
    Samples sum = silence(ms);
    for (const Mode& mode : modes) {
        const std::int64_t chz = kC_chz * mode.hz / 1000;
        add(sum, shaped(tone(ms, chz, chz), 1, mode.half_life_ms), 0, mode.percent);
    }
    return {name, eight_bits(sum, false)};
}

// Swells for half a second, then goes on: pairs of tones a cycle of the loop apart beat once in each turn of it.
ModuleSample pad() {
    constexpr std::size_t kLoop = 8'192, kRise = 4'096;
    constexpr std::int32_t kCycles = kLoop / kCycle;
    Samples loop(kLoop);
    for (const auto& [cycles, percent] : {std::pair{kCycles, 60},
                                          {kCycles - 1, 32},
                                          {kCycles + 1, 32},
                                          {2 * kCycles, 22},
                                          {2 * kCycles + 1, 14},
                                          {3 * kCycles, 9}})
        add(loop, cycles_in(kLoop, cycles), 0, percent);
    Samples all(loop.end() - std::ptrdiff_t{kRise}, loop.end());
    for (std::size_t i = 0; i < kRise; ++i)
        all[i] = static_cast<std::int32_t>(std::int64_t{all[i]} * static_cast<std::int64_t>(i) / std::int64_t{kRise});
    all.insert(all.end(), loop.begin(), loop.end());
    return {"pad", eight_bits(all, true), 64, kRise, kLoop};
}

// In the order of Instrument.
std::vector<ModuleSample> instruments() {
    return {ringing_note("celesta", 560, {{1'000, 105, 100}, {2'001, 60, 20}, {4'004, 42, 34}, {9'200, 14, 12}}),
            ringing_note("harp", 520,
                         {{1'000, 80, 100}, {2'000, 50, 46}, {3'001, 34, 26}, {4'003, 22, 14}, {5'006, 14, 8}}),
            pad(), ringing_note("bass", 700, {{500, 150, 100}, {1'000, 90, 46}, {1'500, 50, 16}}),
            ringing_note("glass", 900, {{1'000, 190, 100}, {2'760, 105, 40}, {5'404, 45, 18}})};
}

struct Chord {
    std::array<std::int32_t, 5> harp;  ///< up, and down again
    std::array<std::int32_t, 2> pad;
    std::int32_t bass;  ///< sounds an octave lower
};
constexpr Chord kDm9{{D2, A2, C3, E3, F3}, {F2, C3}, D1}, kB7{{As1, F2, A2, D3, F3}, {D2, A2}, As1},
    kF7{{F2, C3, E3, G3, A3}, {E2, A2}, F1}, kC9{{C2, G2, D3, E3, G3}, {E2, G2}, C1},
    kGm9{{G1, D2, A2, As2, D3}, {D2, As2}, G1}, kA7{{A1, E2, G2, Cs3, E3}, {Cs2, G2}, A1},
    kGm7{{G1, D2, F2, As2, D3}, {F2, As2}, G1}, kC7{{C2, G2, As2, E3, G3}, {E2, As2}, C1},
    kEm7{{E2, As2, D3, E3, G3}, {D2, G2}, E1};

using Bars = std::array<Chord, 4>;
constexpr Bars kVerse{kDm9, kB7, kF7, kC9}, kAnswer{kDm9, kB7, kGm9, kA7}, kBridge{kGm7, kC7, kF7, kB7},
    kReturn{kEm7, kA7, kDm9, kDm9};

struct MelodyNote {
    std::size_t row;
    std::int32_t note;
};
using Melody = std::vector<MelodyNote>;

// Channels: bass, two of the pad, two of the harp by turns, melody, its echo, glass.
enum Channel : std::size_t { BassPart, PadLow, PadHigh, HarpLeft, HarpRight, Lead, Echo, GlassPart };
constexpr std::array<std::int32_t, kModuleChannels> kPans_128{64, 40, 88, 24, 104, 56, 100, 80};
constexpr std::int32_t kSetVolume = 0xc, kSetPan = 0x8;
constexpr std::size_t kBarRows = 16, kEchoRows = 3;

ModuleCell cell(std::int32_t note, Instrument instrument, std::int32_t volume) {
    return {period_of(note), instrument, kSetVolume, volume};
}

void write_bar(const Chord& chord, std::size_t first_row, ModulePattern& pattern) {
    constexpr std::array<std::size_t, 8> kUpAndDown{0, 1, 2, 3, 4, 3, 2, 1};
    constexpr std::array<std::int32_t, 8> kHarpVolumes{33, 24, 27, 24, 31, 23, 25, 21};
    pattern[first_row][BassPart] = cell(chord.bass, Bass, 60);
    pattern[first_row + 12][BassPart] = cell(chord.bass, Bass, 33);
    pattern[first_row][PadLow] = cell(chord.pad[0], Pad, 22);
    pattern[first_row][PadHigh] = cell(chord.pad[1], Pad, 18);
    for (std::size_t i = 0; i < kUpAndDown.size(); ++i)
        pattern[first_row + 2 * i][i % 2 == 0 ? HarpLeft : HarpRight] =
            cell(chord.harp[kUpAndDown[i]], Harp, kHarpVolumes[i]);
}

ModulePattern make_pattern(const Bars& bars, const Melody& melody, const Melody& glass) {
    ModulePattern pattern{};
    for (std::size_t bar = 0; bar < bars.size(); ++bar) write_bar(bars[bar], bar * kBarRows, pattern);
    for (const MelodyNote& one : melody) {
        pattern[one.row][Lead] = cell(one.note, Celesta, 58);
        if (one.row + kEchoRows < kModuleRows) pattern[one.row + kEchoRows][Echo] = cell(one.note, Celesta, 19);
    }
    for (const MelodyNote& one : glass) pattern[one.row][GlassPart] = cell(one.note, Glass, 26);
    // On a row where nothing begins: a cell has room for one effect.
    for (std::size_t i = 0; i < kModuleChannels; ++i) {
        pattern[1][i].effect = kSetPan;
        pattern[1][i].parameter = kPans_128[i];
    }
    return pattern;
}

std::vector<ModulePattern> patterns() {
    return {
        make_pattern(kVerse, {}, {{8, D3}, {24, A3}, {56, E3}}),
        make_pattern(
            kVerse,
            {{0, A3}, {6, G3}, {8, F3}, {12, E3}, {16, F3}, {24, D3}, {32, A3}, {40, G3}, {44, E3}, {48, G3}, {56, E3}},
            {}),
        make_pattern(kAnswer,
                     {{0, F3},
                      {6, E3},
                      {8, F3},
                      {12, A3},
                      {16, As3},
                      {24, A3},
                      {32, As3},
                      {38, A3},
                      {40, G3},
                      {44, D3},
                      {48, E3},
                      {56, Cs3}},
                     {{60, A3}}),
        make_pattern(kBridge,
                     {{0, D3},
                      {4, F3},
                      {8, As3},
                      {16, G3},
                      {24, E3},
                      {32, C3},
                      {36, E3},
                      {40, A3},
                      {48, A3},
                      {52, G3},
                      {56, F3}},
                     {{28, As3}}),
        make_pattern(kReturn, {{0, G3}, {8, E3}, {12, D3}, {16, Cs3}, {24, E3}, {32, F3}, {40, E3}, {44, D3}, {48, D3}},
                     {{52, A3}, {58, D3}}),
        make_pattern(kVerse,
                     {{0, D3},
                      {4, E3},
                      {8, F3},
                      {12, A3},
                      {16, F3},
                      {20, A3},
                      {24, F3},
                      {32, E3},
                      {36, G3},
                      {40, A3},
                      {48, G3},
                      {54, E3},
                      {56, D3}},
                     {{30, D3}}),
        make_pattern(kVerse, {{0, A3}, {16, F3}, {32, E3}, {48, D3}}, {{10, E3}, {26, A3}, {42, G3}, {58, D3}}),
    };
}

}  // namespace

std::vector<std::uint8_t> make_title_music() {
    Module module;
    module.title = "after closing time";
    module.samples = instruments();
    module.patterns = patterns();
    module.orders = {0, 1, 2, 3, 4, 5, 2, 3, 4, 6};
    return encode_module(module);
}

}  // namespace oblong::sound_source
