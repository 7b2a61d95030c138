#include "game/simulation/demo.h"

#include <algorithm>
#include <string>
#include <string_view>

#include "engine/base/input_error.h"

namespace oblong {
namespace {

constexpr std::string_view kMagic = "OBLGDEMO";
constexpr std::uint32_t kVersion = 1;
constexpr std::size_t kHeaderBytes = 28, kTickBytes = 15;

template <class Int>
void append(std::vector<std::uint8_t>& bytes, Int number) {
    for (std::size_t byte = 0; byte < sizeof(Int); ++byte)
        bytes.push_back(static_cast<std::uint8_t>(static_cast<std::uint64_t>(number) >> (8 * byte)));
}

// Reads numbers one after the other; the caller has checked that there are enough bytes.
struct Reader {
    std::span<const std::uint8_t> bytes;
    std::size_t at = 0;

    template <class Int>
    Int next() {
        std::uint64_t number = 0;
        for (std::size_t byte = 0; byte < sizeof(Int); ++byte) number |= std::uint64_t{bytes[at++]} << (8 * byte);
        return static_cast<Int>(number);
    }
};

void expect(bool is_right, std::size_t offset, const std::string& what_is_wrong) {
    if (!is_right) throw InputError("offset " + std::to_string(offset), what_is_wrong);
}

void check_magic(std::span<const std::uint8_t> bytes) {
    expect(bytes.size() >= kHeaderBytes, 0,
           "the file has " + std::to_string(bytes.size()) + " bytes, a demo has 28 or more");
    expect(std::equal(kMagic.begin(), kMagic.end(), bytes.begin()), 0, "no demo: expected 'OBLGDEMO'");
}

std::uint32_t read_header(Reader& reader, Demo& demo) {
    const auto version = reader.next<std::uint32_t>();
    expect(version == kVersion, 8, "version " + std::to_string(version) + ", expected 1");
    const auto rate = reader.next<std::uint32_t>();
    expect(rate == kTicksPerSecond, 12, std::to_string(rate) + " ticks a second, expected 35");
    demo.start_hash = reader.next<std::uint64_t>();
    return reader.next<std::uint32_t>();
}

DemoTick read_tick(Reader& reader) {
    DemoTick tick;
    tick.input.forward = reader.next<std::int8_t>();
    tick.input.right = reader.next<std::int8_t>();
    expect(tick.input.forward != -128 && tick.input.right != -128, reader.at - 2,
           "a speed of -128, expected -127 to 127");
    tick.input.yaw = reader.next<std::int16_t>();
    tick.input.pitch = reader.next<std::int16_t>();
    tick.input.buttons = reader.next<std::uint8_t>();
    expect((tick.input.buttons & ~(kJumpButton | kRespawnButton)) == 0, reader.at - 1,
           "unknown buttons, expected 0 to 3");
    tick.state_hash = reader.next<std::uint64_t>();
    return tick;
}

}  // namespace

std::vector<std::uint8_t> encode_demo(const Demo& demo) {
    std::vector<std::uint8_t> bytes(kMagic.begin(), kMagic.end());
    append(bytes, kVersion);
    append(bytes, static_cast<std::uint32_t>(kTicksPerSecond));
    append(bytes, demo.start_hash);
    append(bytes, static_cast<std::uint32_t>(demo.ticks.size()));
    for (const DemoTick& tick : demo.ticks) {
        append(bytes, tick.input.forward);
        append(bytes, tick.input.right);
        append(bytes, tick.input.yaw);
        append(bytes, tick.input.pitch);
        append(bytes, tick.input.buttons);
        append(bytes, tick.state_hash);
    }
    return bytes;
}

Demo decode_demo(std::span<const std::uint8_t> bytes) {
    check_magic(bytes);
    Demo demo;
    Reader reader{bytes, kMagic.size()};
    const std::uint32_t count = read_header(reader, demo);
    const std::size_t there = bytes.size() - kHeaderBytes;
    expect(there == std::size_t{count} * kTickBytes, 24,
           std::to_string(count) + " ticks of 15 bytes announced, " + std::to_string(there) + " bytes follow");
    demo.ticks.reserve(count);
    for (std::uint32_t i = 0; i < count; ++i) demo.ticks.push_back(read_tick(reader));
    return demo;
}

}  // namespace oblong
