#include "tools/demo_level/sounds/module_file.h"

namespace oblong::sound_source {
namespace {

constexpr std::size_t kMostSamples = 31, kMostOrders = 128, kTitleSize = 20, kNameSize = 22;

class Writer {
  public:
    void text(const std::string& text, std::size_t size) {
        for (std::size_t i = 0; i < size; ++i) byte(i < text.size() ? text[i] : 0);
    }
    void byte(std::int32_t value) { bytes.push_back(static_cast<std::uint8_t>(value & 0xff)); }
    /// Big-endian, and in words of two bytes, as all lengths are.
    void words(std::size_t samples) {
        byte(static_cast<std::int32_t>(samples / 2 >> 8));
        byte(static_cast<std::int32_t>(samples / 2));
    }

    std::vector<std::uint8_t> bytes;
};

void write_sample(const ModuleSample& sample, Writer& writer) {
    constexpr std::size_t kNoLoop = 2;
    writer.text(sample.name, kNameSize);
    writer.words(sample.wave.size());
    writer.byte(0);  // fine tune
    writer.byte(sample.volume);
    writer.words(static_cast<std::size_t>(sample.loop_start));
    writer.words(sample.loop_length > 0 ? static_cast<std::size_t>(sample.loop_length) : kNoLoop);
}

void write_cell(const ModuleCell& cell, Writer& writer) {
    writer.byte((cell.sample & 0xf0) | cell.period >> 8);
    writer.byte(cell.period);
    writer.byte((cell.sample & 0x0f) << 4 | cell.effect);
    writer.byte(cell.parameter);
}

}  // namespace

std::vector<std::uint8_t> encode_module(const Module& module) {
    constexpr std::int32_t kRestartByte = 127;
    Writer writer;
    writer.text(module.title, kTitleSize);
    for (std::size_t i = 0; i < kMostSamples; ++i)
        write_sample(i < module.samples.size() ? module.samples[i] : ModuleSample{}, writer);
    writer.byte(static_cast<std::int32_t>(module.orders.size()));
    writer.byte(kRestartByte);
    for (std::size_t i = 0; i < kMostOrders; ++i) writer.byte(i < module.orders.size() ? module.orders[i] : 0);
    writer.text("8CHN", 4);
    for (const ModulePattern& pattern : module.patterns)
        for (const auto& row : pattern)
            for (const ModuleCell& cell : row) write_cell(cell, writer);
    for (const ModuleSample& sample : module.samples)
        for (const std::int8_t value : sample.wave) writer.byte(value);
    return writer.bytes;
}

std::int32_t period_of(std::int32_t note) {
    constexpr std::array<std::int32_t, 12> kLowest{856, 808, 762, 720, 678, 640, 604, 570, 538, 508, 480, 453};
    const std::int32_t octave = note / 12;
    return (kLowest[static_cast<std::size_t>(note % 12)] + (1 << octave >> 1)) >> octave;
}

}  // namespace oblong::sound_source
