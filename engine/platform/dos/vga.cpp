#include "engine/platform/dos/vga.h"

#include <algorithm>
#include <array>
#include <cstring>
#include <span>

#include "engine/base/table.h"
#include "engine/platform/dos/kernel/ports.h"
#include "engine/platform/dos/layout.h"

namespace oblong::dos {
namespace {

constexpr std::uint16_t kMiscellaneous = 0x3c2, kSequencer = 0x3c4, kColourIndex = 0x3c8, kColour = 0x3c9;
constexpr std::uint16_t kCrtController = 0x3d4, kInputStatus = 0x3da;

// An indexed register: the index goes to a port, the value to the next port.
struct Register {
    std::uint8_t index, value;
};
void write(std::uint16_t port, Register to) {
    write_port(port, to.index);
    write_port(static_cast<std::uint16_t>(port + 1), to.value);
}

// In mode 13h the VGA distributes four consecutive bytes to its four planes ("chain 4"), which leaves three quarters of
// its memory unused. With chain 4 off, a write goes to the planes selected by the sequencer's register 2, which allows
// modes of more pixels (M. Abrash, "Mode X: 256-Color VGA Magic", Dr. Dobb's Journal, July 1991).
constexpr Register kNoChain4{0x04, 0x06};
constexpr Register kUnchained[] = {{0x14, 0x00}, {0x17, 0xe3}};  // of the CRT controller: byte addressing
constexpr Register k400Lines[] = {{0x09, 0x40}};                 // no line doubling
// 480 of 525 lines, as in mode 12h: total, overflow, retrace, last line shown, blanking.
constexpr Register k480Lines[] = {{0x06, 0x0d}, {0x07, 0x3e}, {0x10, 0xea}, {0x11, 0xac},
                                  {0x12, 0xdf}, {0x15, 0xe7}, {0x16, 0x06}};
constexpr Register kTwice[] = {{0x09, 0x41}}, kOnce[] = {{0x09, 0x40}};
// 360 pixels a line at 28.3 MHz, in units of four: total, shown, blanking, retrace, line pitch.
constexpr Register k360Pixels[] = {{0x00, 0x6b}, {0x01, 0x59}, {0x02, 0x5a}, {0x03, 0x8e},
                                   {0x04, 0x5e}, {0x05, 0x8a}, {0x13, 0x2d}};

struct ModeRegisters {
    VgaMode mode;
    std::uint8_t miscellaneous;  // the clock, and the sync polarities, which tell the monitor the number of lines
    std::span<const Register> lines, doubling, columns;
};
constexpr ModeRegisters kModes[] = {{{320, 240}, 0xe3, k480Lines, kTwice, {}},
                                    {{320, 400}, 0x63, {}, k400Lines, {}},
                                    {{360, 480}, 0xe7, k480Lines, kOnce, k360Pixels}};
constexpr VgaMode kMode13h{320, 200};

const ModeRegisters* find_mode(VgaMode mode) {
    for (const ModeRegisters& each : kModes)
        if (each.mode == mode) return &each;
    return nullptr;
}

std::uint8_t* screen() {
    return reinterpret_cast<std::uint8_t*>(VGA_ADDRESS);
}

// A quarter of the columns at a time: column x is in plane x % 4.
void copy_to_planes(Framebuffer picture) {
    const std::int32_t stride = picture.width_px / 4;
    for (std::uint8_t plane = 0; plane < 4; ++plane) {
        write(kSequencer, {0x02, static_cast<std::uint8_t>(1 << plane)});
        std::uint8_t* to = screen();
        for (std::int32_t y = 0; y < picture.height_px; ++y) {
            const std::uint8_t* from = picture.row(y) + plane;
            for (std::int32_t x = 0; x < stride; ++x, from += 4) *to++ = *from;
        }
    }
}

void copy_nearest(Framebuffer picture) {
    std::array<std::int32_t, kMode13h.width_px> columns;
    for (std::int32_t x = 0; x < kMode13h.width_px; ++x) columns[as_size(x)] = x * picture.width_px / kMode13h.width_px;
    std::uint8_t* to = screen();
    for (std::int32_t y = 0; y < kMode13h.height_px; ++y) {
        const std::uint8_t* row = picture.row(y * picture.height_px / kMode13h.height_px);
        for (const std::int32_t column : columns) *to++ = row[column];
    }
}

}  // namespace

// First writes mode 13h's values of all registers that any mode changes.
void Vga::set_mode(VgaMode mode) {
    static constexpr Register k13h[] = {{0x00, 0x5f}, {0x01, 0x4f}, {0x02, 0x50}, {0x03, 0x82}, {0x04, 0x54},
                                        {0x05, 0x80}, {0x06, 0xbf}, {0x07, 0x1f}, {0x09, 0x41}, {0x10, 0x9c},
                                        {0x11, 0x0e}, {0x12, 0x8f}, {0x13, 0x28}, {0x14, 0x40}, {0x15, 0x96},
                                        {0x16, 0xb9}, {0x17, 0xa3}};
    constexpr Register kReset{0x00, 0x01}, kRun{0x00, 0x03}, kChain4{0x04, 0x0e}, kAllPlanes{0x02, 0x0f};
    const ModeRegisters* const wanted = find_mode(mode);
    write(kSequencer, kReset);
    write_port(kMiscellaneous, wanted != nullptr ? wanted->miscellaneous : 0x63);
    write(kSequencer, kRun);
    write(kSequencer, wanted != nullptr ? kNoChain4 : kChain4);
    write(kSequencer, kAllPlanes);
    write(kCrtController, {0x11, 0x0e});  // unlocks the first eight
    const auto write_all = [](std::span<const Register> registers) {
        for (const Register& each : registers) write(kCrtController, each);
    };
    write_all(k13h);
    if (wanted != nullptr) {
        write(kCrtController, {0x11, 0x0e});
        write_all(wanted->columns);
        write_all(wanted->lines);
        write_all(wanted->doubling);
        write_all(kUnchained);
    }
    std::memset(screen(), 0, 65536);
    mode_ = mode;
}

void Vga::wait_for_retrace() {
    constexpr std::uint8_t kIsRetrace = 8;
    constexpr int kMost = 100'000;  // reads: a card without a retrace must not stop the game
    for (int i = 0; i < kMost && (read_port(kInputStatus) & kIsRetrace) != 0; ++i) {
    }
    for (int i = 0; i < kMost && (read_port(kInputStatus) & kIsRetrace) == 0; ++i) {
    }
}

void Vga::set_palette(const Palette& palette) {
    if (has_palette_ && palette.colours == palette_.colours) return;
    wait_for_retrace();  // else visible colours flicker
    write_port(kColourIndex, 0);
    for (const Rgb8& colour : palette.colours)
        for (const std::uint8_t part : {colour.red, colour.green, colour.blue}) write_port(kColour, narrow_dac6(part));
    palette_ = palette;
    has_palette_ = true;
}

void Vga::show(Framebuffer picture, const Palette& palette) {
    const VgaMode size{picture.width_px, picture.height_px};
    const VgaMode mode = find_mode(size) != nullptr ? size : kMode13h;
    if (mode != mode_) set_mode(mode);
    set_palette(palette);
    if (mode != kMode13h)
        copy_to_planes(picture);
    else if (size == kMode13h)
        for (std::int32_t y = 0; y < kMode13h.height_px; ++y) std::memcpy(screen() + 320 * y, picture.row(y), 320);
    else
        copy_nearest(picture);
}

}  // namespace oblong::dos
