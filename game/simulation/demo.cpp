#include "game/simulation/demo.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "engine/base/little_endian.h"
#include "game/simulation/state.h"

namespace oblong {
namespace {

constexpr std::string_view kDemoMagic = "OBLGDEMO";
constexpr std::uint32_t kDemoVersion = 2;  // 1: without view and work
constexpr std::size_t kDemoHeaderBytes = 28, kTickBytes = 15, kBytesOfView = kViewDials + 2;

void read_view(LittleEndianReader& reader, TickInput& input) {
    for (std::size_t i = 0; i < kViewDials; ++i) {
        const std::size_t count = all_view_dials()[i].values.size();
        input.view[i] = reader.next<std::uint8_t>();
        expect_at(reader.offset() - 1, input.view[i] < count,
                  std::to_string(input.view[i]) + " for " + std::string(all_view_dials()[i].key) + ", expected 0 to " +
                      std::to_string(count - 1));
    }
    input.work = reader.next<std::uint16_t>();
}

DemoTick read_tick(LittleEndianReader& reader, std::uint32_t version) {
    DemoTick tick;
    tick.input.forward = reader.next<std::int8_t>();
    tick.input.right = reader.next<std::int8_t>();
    expect_at(reader.offset() - 2, tick.input.forward != -128 && tick.input.right != -128,
              "a speed of -128, expected -127 to 127");
    tick.input.yaw = reader.next<std::int16_t>();
    tick.input.pitch = reader.next<std::int16_t>();
    tick.input.buttons = reader.next<std::uint8_t>();
    expect_at(reader.offset() - 1, (tick.input.buttons & ~(kJumpButton | kRespawnButton | kVisitButton)) == 0,
              "unknown buttons, expected 0 to 7");
    if (version != 1) read_view(reader, tick.input);
    tick.state_hash = reader.next<std::uint64_t>();
    return tick;
}

}  // namespace

std::uint64_t start_hash_of(const GameState& start, std::uint64_t rules_hash) {
    return hash_of(start) ^ rules_hash;
}

std::vector<std::uint8_t> encode_demo(const Demo& demo) {
    std::vector<std::uint8_t> bytes(kDemoMagic.begin(), kDemoMagic.end());
    append_little_endian(bytes, kDemoVersion);
    append_little_endian(bytes, static_cast<std::uint32_t>(kTicksPerSecond));
    append_little_endian(bytes, demo.start_hash);
    append_little_endian(bytes, static_cast<std::uint32_t>(demo.ticks.size()));
    for (const DemoTick& tick : demo.ticks) {
        append_little_endian(bytes, tick.input.forward);
        append_little_endian(bytes, tick.input.right);
        append_little_endian(bytes, tick.input.yaw);
        append_little_endian(bytes, tick.input.pitch);
        append_little_endian(bytes, tick.input.buttons);
        bytes.insert(bytes.end(), tick.input.view.begin(), tick.input.view.end());
        append_little_endian(bytes, tick.input.work);
        append_little_endian(bytes, tick.state_hash);
    }
    return bytes;
}

Demo decode_demo(std::span<const std::uint8_t> bytes) {
    expect_at(0, bytes.size() >= kDemoHeaderBytes,
              "the file has " + std::to_string(bytes.size()) + " bytes, expected 28 or more of a demo");
    expect_at(0, std::equal(kDemoMagic.begin(), kDemoMagic.end(), bytes.begin()), "no demo: expected 'OBLGDEMO'");
    LittleEndianReader reader(bytes, kDemoMagic.size());
    const auto version = reader.next<std::uint32_t>();
    expect_at(8, version == 1 || version == kDemoVersion, "version " + std::to_string(version) + ", expected 1 or 2");
    const auto rate = reader.next<std::uint32_t>();
    expect_at(12, rate == kTicksPerSecond, std::to_string(rate) + " ticks a second, expected 35");
    Demo demo;
    demo.start_hash = reader.next<std::uint64_t>();
    const auto count = reader.next<std::uint32_t>();
    const std::size_t there = bytes.size() - kDemoHeaderBytes;
    const std::size_t each = version == 1 ? kTickBytes : kTickBytes + kBytesOfView;
    expect_at(24, there == std::uint64_t{count} * each,
              std::to_string(count) + " ticks announced, expected " + std::to_string(each) + " bytes for each, " +
                  std::to_string(there) + " follow");
    demo.ticks.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) demo.ticks.push_back(read_tick(reader, version));
    return demo;
}

}  // namespace oblong
