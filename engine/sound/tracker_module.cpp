#include "engine/sound/tracker_module.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include "engine/base/little_endian.h"

namespace oblong {
namespace {

constexpr std::size_t kSamples = 31, kSampleHeadBytes = 30, kTitleBytes = 20, kMostOrders = 128, kNoteBytes = 4;
constexpr int kMostSample = 31;
constexpr std::uint8_t kOthersRestart = 127;  // of other trackers of 4 channels, in place of an order
constexpr std::size_t kOrderCount = kTitleBytes + kSamples * kSampleHeadBytes, kOrders = kOrderCount + 2;
constexpr std::size_t kSignature = kOrders + kMostOrders, kPatternsAt = kSignature + 4;

std::size_t doubled_u16(std::span<const std::uint8_t> file, std::size_t at) {
    return 2 * (std::size_t{file[at]} * 256 + file[at + 1]);
}

// The values of samples follow at the end of the file.
ModuleSample sample_head(std::span<const std::uint8_t> file, std::size_t at) {
    ModuleSample sample;
    sample.samples.resize(doubled_u16(file, at + 22));
    const std::int32_t finetune = file[at + 24] & 15;
    sample.finetune_8 = finetune < 8 ? finetune : finetune - 16;
    sample.volume_64 = std::min<std::int32_t>(file[at + 25], kMostModuleVolume_64);
    sample.loop_start = doubled_u16(file, at + 26);
    sample.loop_length = doubled_u16(file, at + 28);
    return sample;
}

// In this format a loop of one word means no loop. ProTracker plays all of a sample before a loop from its beginning,
// others play no more of it than the loop.
void bound_loop(ModuleSample& sample, bool is_whole_first) {
    sample.loop_start = std::min(sample.loop_start, sample.samples.size());
    sample.loop_length = std::min(sample.loop_length, sample.samples.size() - sample.loop_start);
    if (sample.loop_length <= 2) sample.loop_start = sample.loop_length = 0;
    const bool is_whole = sample.loop_length == 0 || (sample.loop_start == 0 && is_whole_first);
    sample.played = is_whole ? sample.samples.size() : sample.loop_start + sample.loop_length;
}

struct ModuleMark {
    std::string_view letters;
    std::size_t channels;
};
constexpr std::array<ModuleMark, 14> kMarks{{{"M.K.", 4},
                                             {"M!K!", 4},
                                             {"M&K!", 4},
                                             {"N.T.", 4},
                                             {"FLT4", 4},
                                             {"FLT8", 8},
                                             {"EXO4", 4},
                                             {"OCTA", 8},
                                             {"OKTA", 8},
                                             {"CD81", 8},
                                             {"CD61", 6},
                                             {"TDZ1", 1},
                                             {"TDZ2", 2},
                                             {"TDZ3", 3}}};

// From the four letters after the orders; 0: unknown.
std::size_t channels_of(std::string_view signature) {
    for (const ModuleMark& mark : kMarks)
        if (mark.letters == signature) return mark.channels;
    const auto digit = [&](std::size_t at) {
        const bool is_digit = signature[at] >= '0' && signature[at] <= '9';
        return is_digit ? static_cast<std::size_t>(signature[at] - '0') : kMostModuleChannels + 1;
    };
    std::size_t channels = 0;
    if (signature.substr(1) == "CHN") channels = digit(0);
    if (signature.substr(2) == "CH") channels = digit(0) * 10 + digit(1);
    return channels <= kMostModuleChannels ? channels : 0;
}

int sample_number(std::span<const std::uint8_t> file, std::size_t at) {
    return (file[at] & 0xf0) | file[at + 2] >> 4;
}

ModuleNote note_at(std::span<const std::uint8_t> file, std::size_t at) {
    ModuleNote note;
    const int sample = sample_number(file, at);
    note.sample = static_cast<std::uint8_t>(sample <= kMostSample ? sample : 0);
    note.period = static_cast<std::uint16_t>((file[at] & 15) << 8 | file[at + 1]);
    note.effect = file[at + 2] & 15;
    note.parameter = file[at + 3];
    return note;
}

/// A few notes may name a sample that there is not. Where many do, the notes are written otherwise, under this mark.
void check_sample_numbers(std::span<const std::uint8_t> file, std::size_t notes) {
    constexpr std::size_t kFew = 64;
    std::size_t bad = 0;
    for (std::size_t i = 0; i < notes; ++i)
        if (sample_number(file, kPatternsAt + i * kNoteBytes) > kMostSample) ++bad;
    expect_at(kPatternsAt, bad <= kFew || bad <= notes / 4,
              std::to_string(bad) + " of " + std::to_string(notes) +
                  " notes name samples above 31, expected the notes of a tracker module, not packed");
}

// Effect 8 pans a channel from left, 0, to right, 255; DOS trackers wrote 128 for right.
void double_small_pannings(std::vector<ModuleNote>& notes) {
    constexpr std::uint8_t kPanningEffect = 8, kRight = 128;
    const auto is_above = [](const ModuleNote& note) {
        return note.effect == kPanningEffect && note.parameter > kRight;
    };
    if (std::any_of(notes.begin(), notes.end(), is_above)) return;
    for (ModuleNote& note : notes)
        if (note.effect == kPanningEffect)
            note.parameter = static_cast<std::uint8_t>(std::min(2 * note.parameter, 255));
}

/// ModPlug's packing: a table of 16 differences, then two of their numbers a byte, the lower half first.
constexpr std::string_view kPackedMark = "ADPCM";
constexpr std::size_t kPackedHeadBytes = 5 + 16;

bool is_packed(std::span<const std::uint8_t> at) {
    return at.size() >= kPackedHeadBytes && std::equal(kPackedMark.begin(), kPackedMark.end(), at.begin());
}

std::size_t count_of(std::span<const std::uint8_t> orders) {
    return std::size_t{*std::max_element(orders.begin(), orders.end())} + 1;
}

/// What takes the bytes after the head: patterns, then samples.
struct ModuleLayout {
    std::size_t patterns = 0, channels = 0;
    std::size_t size(std::size_t sample_bytes) const {
        return kPatternsAt + patterns * kPatternRows * channels * kNoteBytes + sample_bytes;
    }
};

/// The file has the patterns that are not played, too; but behind the orders that are played, there may be junk. And
/// the mark of 4 channels may be that of 8, by Mod's Grave. The layout of the file's size is right.
ModuleLayout layout_of(std::span<const std::uint8_t> file, ModuleLayout marked, std::size_t sample_bytes,
                       std::size_t played_patterns) {
    const auto misses = [&](const ModuleLayout& layout) {
        const std::size_t size = layout.size(sample_bytes);
        return size > file.size() ? size - file.size() : file.size() - size;
    };
    const ModuleLayout played{played_patterns, marked.channels}, grave{marked.patterns, 8};
    const bool may_be_grave = marked.channels == 4 && file[kOrderCount + 1] == 0;  // no restart, unlike others' 127
    if (may_be_grave && misses(grave) < 2 && misses(marked) >= 2) return grave;
    const bool is_marked = is_packed(file.subspan(std::min(marked.size(0), file.size())));
    return !is_marked && misses(played) < misses(marked) ? played : marked;
}

/// Whether all notes that are played are ones that ProTracker has.
bool are_protrackers(const TrackerModule& module) {
    const auto is_protrackers = [](const ModuleNote& note) {
        return note.period == 0 || (note.period >= kLeastPeriod && note.period <= kMostPeriod);
    };
    return std::all_of(module.orders.begin(), module.orders.end(), [&](std::size_t pattern) {
        const std::size_t notes = kPatternRows * module.channels;
        const std::span<const ModuleNote> played = std::span(module.notes).subspan(pattern * notes, notes);
        return std::all_of(played.begin(), played.end(), is_protrackers);
    });
}

/// Startrekker's 8 channels are pairs of patterns of 4, and orders count those.
void join_pairs(TrackerModule& module) {
    for (std::uint8_t& order : module.orders) order /= 2;
    const std::vector<ModuleNote> apart = module.notes;
    for (std::size_t i = 0; i < apart.size(); ++i) {
        const std::size_t pair = i / (kPatternRows * 8), in_pair = i % (kPatternRows * 8);
        const std::size_t half = in_pair / (kPatternRows * 4), row = in_pair % (kPatternRows * 4) / 4;
        module.notes[(pair * kPatternRows + row) * 8 + half * 4 + i % 4] = apart[i];
    }
}

/// Reads a sample's values; the number of bytes they take.
std::size_t read_values(std::vector<std::int8_t>& values, std::span<const std::uint8_t> at) {
    if (!values.empty() && is_packed(at)) {
        values.resize(std::min(values.size(), 2 * (at.size() - kPackedHeadBytes)));
        std::uint8_t value = 0;
        for (std::size_t i = 0; i < values.size(); ++i) {
            const int number = at[kPackedHeadBytes + i / 2] >> (i % 2 * 4) & 15;
            value = static_cast<std::uint8_t>(value + at[kPackedMark.size() + static_cast<std::size_t>(number)]);
            values[i] = static_cast<std::int8_t>(value);
        }
        return kPackedHeadBytes + (values.size() + 1) / 2;
    }
    values.resize(std::min(values.size(), at.size()));
    std::transform(at.begin(), at.begin() + std::ssize(values), values.begin(),
                   [](std::uint8_t value) { return static_cast<std::int8_t>(value); });
    return values.size();
}

}  // namespace

TrackerModule parse_module(std::span<const std::uint8_t> file) {
    expect_at(file.size(), file.size() >= kPatternsAt,
              "the file ends here, expected a tracker module of at least " + std::to_string(kPatternsAt) + " bytes");
    const std::string_view signature(reinterpret_cast<const char*>(file.data()) + kSignature, 4);
    TrackerModule module;
    module.channels = channels_of(signature);
    expect_at(kSignature, module.channels > 0,
              "'" + std::string(signature) + "', expected 'M.K.' or '8CHN', as a tracker module of 31 samples has it");
    const std::size_t order_count = file[kOrderCount];
    expect_at(kOrderCount, order_count >= 1 && order_count <= kMostOrders,
              std::to_string(order_count) + " patterns to play, expected 1 to 128");
    const auto orders = file.subspan(kOrders, order_count);
    module.orders.assign(orders.begin(), orders.end());
    if (file[kOrderCount + 1] < order_count) module.restart = file[kOrderCount + 1];

    std::size_t sample_bytes = 0;
    for (std::size_t i = 0; i < kSamples; ++i) {
        module.samples.push_back(sample_head(file, kTitleBytes + i * kSampleHeadBytes));
        sample_bytes += module.samples.back().samples.size();
    }
    const bool is_paired = signature == "FLT8";
    const auto patterns_of = [&](std::span<const std::uint8_t> some) {
        return is_paired ? count_of(some) / 2 + count_of(some) % 2 : count_of(some);
    };
    const ModuleLayout layout = layout_of(file, {patterns_of(file.subspan(kOrders, kMostOrders)), module.channels},
                                          sample_bytes, patterns_of(orders));
    module.channels = layout.channels;
    module.notes.resize(layout.patterns * kPatternRows * module.channels);
    expect_at(file.size(), (file.size() - kPatternsAt) / kNoteBytes >= module.notes.size(),
              "the file ends here, expected " + std::to_string(layout.patterns) + " patterns");
    check_sample_numbers(file, std::min(patterns_of(orders) * kPatternRows * module.channels, module.notes.size()));
    std::size_t at = kPatternsAt;
    for (ModuleNote& note : module.notes) {
        note = note_at(file, at);
        at += kNoteBytes;
    }
    module.is_protrackers = module.channels == 4 && are_protrackers(module);
    if (is_paired) join_pairs(module);
    double_small_pannings(module.notes);
    for (ModuleSample& sample : module.samples) {
        at += read_values(sample.samples, file.subspan(at));
        bound_loop(sample, module.is_protrackers && file[kOrderCount + 1] != kOthersRestart);
    }
    return module;
}

}  // namespace oblong
