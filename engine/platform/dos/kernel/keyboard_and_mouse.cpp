#include "engine/platform/dos/kernel/kernel.h"
#include "engine/platform/dos/kernel/ports.h"

// One controller (8042) serves both, and interrupts for each byte from one of them.

namespace oblong::dos {
namespace {

constexpr std::uint16_t kData = 0x60, kControl = 0x64;
constexpr std::uint8_t kHasByte = 1, kIsBusy = 2;  // of its status
constexpr int kLongestWait = 20'000;               // reads of it, a microsecond each
constexpr std::size_t kKeys = 256;

volatile std::uint8_t keys[kKeys];  // a ring
volatile std::uint32_t first_key, end_key;
std::uint8_t packet[3];
int packet_size;
MouseState mouse;

bool wait_until(std::uint8_t mask, std::uint8_t wanted) {
    for (int i = 0; i < kLongestWait; ++i)
        if ((read_port(kControl) & mask) == wanted) return true;
    return false;
}

void send(std::uint16_t port, std::uint8_t byte) {
    wait_until(kIsBusy, 0);
    write_port(port, byte);
}
std::uint8_t receive() {
    return wait_until(kHasByte, kHasByte) ? read_port(kData) : 0;
}

void tell_mouse(std::uint8_t byte) {
    constexpr std::uint8_t kToMouse = 0xd4;
    send(kControl, kToMouse);
    send(kData, byte);
    receive();  // the acknowledgement
}

}  // namespace

void start_mouse() {
    constexpr std::uint8_t kEnableMouse = 0xa8, kReadSettings = 0x20, kWriteSettings = 0x60;
    constexpr std::uint8_t kInterrupts = 0x03, kDisabled = 0x30;  // bits of keyboard and mouse
    constexpr std::uint8_t kDefaults = 0xf6, kReport = 0xf4;      // 100 reports a second, four counts a millimetre
    const WithoutInterrupts during;
    send(kControl, kEnableMouse);
    send(kControl, kReadSettings);
    const std::uint8_t settings = receive();
    send(kControl, kWriteSettings);
    send(kData, static_cast<std::uint8_t>((settings | kInterrupts) & ~kDisabled));
    tell_mouse(kDefaults);
    tell_mouse(kReport);
}

void take_key_byte() {
    const std::uint8_t byte = read_port(kData);
    if (end_key - first_key == kKeys) return;
    keys[end_key % kKeys] = byte;
    end_key = end_key + 1;
}

int next_key_byte() {
    if (first_key == end_key) return -1;
    const int byte = keys[first_key % kKeys];
    first_key = first_key + 1;
    return byte;
}

// Three bytes: buttons and signs, motion to the right, motion up.
void take_mouse_byte() {
    constexpr std::uint8_t kIsFirst = 0x08, kLeft = 0x10, kDown = 0x20, kButtons = 0x07;
    const std::uint8_t byte = read_port(kData);
    if (packet_size == 0 && (byte & kIsFirst) == 0) return;
    packet[packet_size++] = byte;
    if (packet_size < 3) return;
    packet_size = 0;
    mouse.x += packet[1] - ((packet[0] & kLeft) != 0 ? 256 : 0);
    mouse.y -= packet[2] - ((packet[0] & kDown) != 0 ? 256 : 0);
    mouse.buttons = packet[0] & kButtons;
}

MouseState take_mouse() {
    const WithoutInterrupts during;
    const MouseState now = mouse;
    mouse.x = mouse.y = 0;
    return now;
}

}  // namespace oblong::dos
