#include "engine/platform/tracker_module.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

constexpr std::size_t kSamples = 31, kSampleHeadBytes = 30, kTitleBytes = 20, kMostOrders = 128, kNoteBytes = 4;
constexpr std::size_t kOrderCount = kTitleBytes + kSamples * kSampleHeadBytes, kOrders = kOrderCount + 2;
constexpr std::size_t kSignature = kOrders + kMostOrders, kPatternsAt = kSignature + 4;

[[noreturn]] void fail(std::size_t offset, const std::string& what) {
    throw InputError("offset " + std::to_string(offset), what);
}

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

// In this format a loop of one word means no loop.
void bound_loop(ModuleSample& sample) {
    sample.loop_start = std::min(sample.loop_start, sample.samples.size());
    sample.loop_length = std::min(sample.loop_length, sample.samples.size() - sample.loop_start);
    if (sample.loop_length <= 2) sample.loop_start = sample.loop_length = 0;
}

// From the four letters after the orders; 0: unknown.
std::size_t channels_of(std::string_view signature) {
    if (signature == "M.K." || signature == "M!K!" || signature == "FLT4") return 4;
    const auto digit = [&](std::size_t at) {
        const bool is_digit = signature[at] >= '0' && signature[at] <= '9';
        return is_digit ? static_cast<std::size_t>(signature[at] - '0') : kMostModuleChannels + 1;
    };
    std::size_t channels = 0;
    if (signature.substr(1) == "CHN") channels = digit(0);
    if (signature.substr(2) == "CH") channels = digit(0) * 10 + digit(1);
    return channels <= kMostModuleChannels ? channels : 0;
}

ModuleNote note_at(std::span<const std::uint8_t> file, std::size_t at) {
    ModuleNote note;
    note.sample = static_cast<std::uint8_t>((file[at] & 0xf0) | file[at + 2] >> 4);
    note.period = static_cast<std::uint16_t>((file[at] & 15) << 8 | file[at + 1]);
    note.effect = file[at + 2] & 15;
    note.parameter = file[at + 3];
    if (note.sample > kSamples)
        fail(at, "a note of sample " + std::to_string(note.sample) + ", expected 0 to " + std::to_string(kSamples));
    return note;
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

}  // namespace

TrackerModule parse_module(std::span<const std::uint8_t> file) {
    if (file.size() < kPatternsAt)
        fail(file.size(),
             "the file ends here, expected a tracker module of at least " + std::to_string(kPatternsAt) + " bytes");
    const std::string_view signature(reinterpret_cast<const char*>(file.data()) + kSignature, 4);
    TrackerModule module;
    module.channels = channels_of(signature);
    if (module.channels == 0)
        fail(kSignature, "'" + std::string(signature) + "', expected 'M.K.' or '8CHN', as a tracker module has it");
    const std::size_t order_count = file[kOrderCount];
    if (order_count < 1 || order_count > kMostOrders)
        fail(kOrderCount, std::to_string(order_count) + " patterns to play, expected 1 to 128");
    const auto orders = file.subspan(kOrders, order_count);
    module.orders.assign(orders.begin(), orders.end());
    if (file[kOrderCount + 1] < order_count) module.restart = file[kOrderCount + 1];

    // The file also has the patterns that are not played.
    const auto all_orders = file.subspan(kOrders, kMostOrders);
    const std::size_t patterns = std::size_t{*std::max_element(all_orders.begin(), all_orders.end())} + 1;
    module.notes.resize(patterns * kPatternRows * module.channels);
    if ((file.size() - kPatternsAt) / kNoteBytes < module.notes.size())
        fail(file.size(), "the file ends here, expected " + std::to_string(patterns) + " patterns");
    std::size_t at = kPatternsAt;
    for (ModuleNote& note : module.notes) {
        note = note_at(file, at);
        at += kNoteBytes;
    }
    double_small_pannings(module.notes);
    for (std::size_t i = 0; i < kSamples; ++i) {
        ModuleSample sample = sample_head(file, kTitleBytes + i * kSampleHeadBytes);
        sample.samples.resize(std::min(sample.samples.size(), file.size() - at));
        for (std::int8_t& value : sample.samples) value = static_cast<std::int8_t>(file[at++]);
        bound_loop(sample);
        module.samples.push_back(std::move(sample));
    }
    return module;
}

}  // namespace oblong
