#include "engine/platform/dos/kernel/kernel.h"
#include "engine/platform/dos/kernel/ports.h"

// Two interrupt controllers (8259) forward interrupts of devices: the timer is line 0, the keyboard line 1; the second
// controller is on line 2 of the first, and the mouse is its line 4, interrupt line 12.

extern "C" const std::uint32_t gates[49];  // of entry.S

namespace oblong::dos {
namespace {

constexpr std::uint16_t kFirst = 0x20, kSecond = 0xa0;  // ports of the controllers; their masks are at the next port
constexpr std::uint8_t kEndOfInterrupt = 0x20;
constexpr std::uint32_t kFirstLine = 32, kTimer = kFirstLine, kKeyboard = kFirstLine + 1, kMouse = kFirstLine + 12;
constexpr std::uint8_t kTimerLine = 1 << 0, kKeyLine = 1 << 1, kSecondLine = 1 << 2;  // of the first one's mask
constexpr std::uint8_t kMouseLine = 1 << 4;                                           // of the second one's
constexpr std::uint32_t kInvalidOpcode = 6, kSystemCall = 0x80;
constexpr std::uint8_t kDosFirstLine = 8, kDosSecondLine = 0x70;  // the interrupt numbers under DOS

struct Gate {
    std::uint16_t low, segment, kind, high;
};
Gate table[kSystemCall + 1];
std::uint8_t first_mask, second_mask;  // under DOS

void set_gate(std::uint32_t number, std::uint32_t address) {
    constexpr std::uint16_t kInterruptGate = 0x8e00, kCode = 0x08;
    table[number] = {static_cast<std::uint16_t>(address), kCode, kInterruptGate,
                     static_cast<std::uint16_t>(address >> 16)};
}

// Sets the interrupt numbers of both controllers' lines, and their masks.
void set_controllers(std::uint8_t first_line, std::uint8_t second_line, std::uint8_t mask,
                     std::uint8_t mask_of_second) {
    constexpr std::uint8_t kInitialise = 0x11, kSecondIsOnLine2 = 4, kOnLine2 = 2, k8086 = 1;
    const auto set = [](std::uint16_t port, const std::uint8_t(&words)[4]) {
        write_port(port, kInitialise);
        for (const std::uint8_t word : words) write_port(static_cast<std::uint16_t>(port + 1), word);
    };
    set(kFirst, {first_line, kSecondIsOnLine2, k8086, mask});
    set(kSecond, {second_line, kOnLine2, k8086, mask_of_second});
}

}  // namespace

void start_interrupts() {
    for (std::uint32_t i = 0; i < 48; ++i) set_gate(i, gates[i]);
    set_gate(kSystemCall, gates[48]);
    struct [[gnu::packed]] {
        std::uint16_t limit;
        const Gate* table;
    } const where{sizeof table - 1, table};
    asm volatile("lidt %0" ::"m"(where));
    first_mask = read_port(kFirst + 1);
    second_mask = read_port(kSecond + 1);
    take_interrupts();
}

void take_interrupts() {
    set_controllers(kFirstLine, kFirstLine + 8, 0xff & ~(kTimerLine | kKeyLine | kSecondLine), 0xff & ~kMouseLine);
}

void restore_interrupts(bool has_keys) {
    const std::uint8_t keys = has_keys ? 0 : kKeyLine, mouse = has_keys ? 0 : kMouseLine;
    set_controllers(kDosFirstLine, kDosSecondLine, first_mask | keys, second_mask | mouse);
}

extern "C" void interrupt(Registers* registers);
void interrupt(Registers* registers) {
    const std::uint32_t number = registers->number;
    if (number == kSystemCall) {
        registers->eax = static_cast<std::uint32_t>(system_call(*registers));
        return;
    }
    if (number >= kFirstLine) {
        if (number == kTimer) tick_clock();
        if (number == kKeyboard) take_key_byte();
        if (number == kMouse) take_mouse_byte();
        if (number >= kFirstLine + 8) write_port(kSecond, kEndOfInterrupt);
        write_port(kFirst, kEndOfInterrupt);
        if (number == kTimer) call_timer_hook();
        return;
    }
    if (number == kInvalidOpcode && emulate(*registers)) return;
    fail(*registers);
}

}  // namespace oblong::dos
