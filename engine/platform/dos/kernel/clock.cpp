#include "engine/platform/dos/kernel/kernel.h"
#include "engine/platform/dos/kernel/ports.h"

// Channel 0 of the timer (8253) counts down from a 16-bit number, interrupts at the end, and restarts. Under DOS the
// number is 65,536: 18.2 interrupts a second.

namespace oblong::dos {
namespace {

constexpr std::uint16_t kCounter0 = 0x40, kMode = 0x43, kInterruptController = 0x20;
constexpr std::uint32_t kPeriod = 4096;  // counts: 291 interrupts a second
volatile std::uint32_t periods;
TimerHook timer_hook;

void set_period(std::uint8_t mode, std::uint32_t counts) {
    write_port(kMode, mode);
    write_port(kCounter0, static_cast<std::uint8_t>(counts));
    write_port(kCounter0, static_cast<std::uint8_t>(counts >> 8));
}

}  // namespace

void start_clock() {
    constexpr std::uint8_t kRateGenerator = 0x34;  // channel 0, low byte then high byte, mode 2
    set_period(kRateGenerator, kPeriod);
}

void restore_clock() {
    constexpr std::uint8_t kSquareWave = 0x36;
    set_period(kSquareWave, 0);
}

void tick_clock() {
    periods = periods + 1;
}

void call_timer_hook() {
    if (timer_hook.function != nullptr) timer_hook.function(timer_hook.argument);
}

void set_timer_hook(const TimerHook& hook) {
    timer_hook = hook;
}

std::uint64_t clock_counts() {
    const WithoutInterrupts during;
    constexpr std::uint8_t kLatch = 0, kReadRequests = 0x0a;
    write_port(kMode, kLatch);
    std::uint32_t left = read_port(kCounter0);
    left |= std::uint32_t{read_port(kCounter0)} << 8;
    std::uint32_t whole = periods;
    // The counter may have restarted with its interrupt still pending.
    write_port(kInterruptController, kReadRequests);
    if ((read_port(kInterruptController) & 1) != 0 && left > kPeriod / 2) ++whole;
    return std::uint64_t{whole} * kPeriod + (kPeriod - left);
}

}  // namespace oblong::dos
