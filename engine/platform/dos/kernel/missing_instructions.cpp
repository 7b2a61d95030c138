#include <type_traits>

#include "engine/platform/dos/kernel/kernel.h"

// The game is compiled for an i486, but Debian's libraries for the Pentium Pro and later: its CMOVs and
// FCMOVs, floating-point comparisons that set flags, and long NOPs are emulated here. They are rare: some hundreds in a
// minute's walk.

namespace oblong::dos {
namespace {

std::uint32_t emulated;

constexpr std::uint32_t kCarry = 1 << 0, kParity = 1 << 2, kZero = 1 << 6, kSign = 1 << 7, kOverflow = 1 << 11;

// Registers in the order of the processor's numbers: eax, ecx, edx, ebx, esp, ebp, esi, edi.
std::uint32_t& register_of(Registers& registers, std::uint32_t number) {
    return (&registers.edi)[7 - number];
}
std::uint32_t value_of(Registers& registers, std::uint32_t number) {
    constexpr std::uint32_t kStackPointer = 4;
    return number == kStackPointer ? registers.stack() : register_of(registers, number);
}

template <class Value>
Value read(std::uint32_t address) {
    return *reinterpret_cast<const Value*>(address);
}

// The operand of a ModR/M byte: a register or an address.
struct Operand {
    bool is_register = false;
    std::uint32_t at = 0;    // the register's number, or the address
    std::uint32_t size = 1;  // of the encoding, bytes
};

Operand operand_at(std::uint32_t at, Registers& registers) {
    const std::uint8_t modrm = read<std::uint8_t>(at);
    const std::uint32_t mode = modrm >> 6, number = modrm & 7;
    if (mode == 3) return {true, number, 1};
    Operand operand;
    std::uint32_t base = number;
    if (number == 4) {  // a SIB byte follows: scale, index, base
        const std::uint8_t sib = read<std::uint8_t>(at + operand.size++);
        const std::uint32_t index = sib >> 3 & 7;
        base = sib & 7;
        if (index != 4) operand.at += value_of(registers, index) << (sib >> 6);
    }
    if (base == 5 && mode == 0) {
        operand.at += read<std::uint32_t>(at + operand.size);
        operand.size += 4;
        return operand;
    }
    operand.at += value_of(registers, base);
    if (mode == 1) operand.at += static_cast<std::uint32_t>(int{read<std::int8_t>(at + operand.size)});
    if (mode == 2) operand.at += read<std::uint32_t>(at + operand.size);
    operand.size += mode == 1 ? 1 : mode == 2 ? 4 : 0;
    return operand;
}

// Whether a condition holds, by its number in instructions.
bool holds(std::uint32_t condition, std::uint32_t flags) {
    const bool is_less = ((flags & kSign) != 0) != ((flags & kOverflow) != 0);
    constexpr std::uint32_t kFlags[] = {kOverflow, kCarry, kZero, kCarry | kZero, kSign, kParity, 0, kZero};
    const std::uint32_t kind = condition >> 1;
    const bool is_so = (flags & kFlags[kind]) != 0 || (kind >= 6 && is_less);
    return is_so != ((condition & 1) != 0);
}

void move_if(std::uint32_t condition, std::uint32_t at, bool is_wide, Registers& registers) {
    const Operand from = operand_at(at, registers);
    if (holds(condition, registers.flags)) {
        const std::uint32_t value = from.is_register ? value_of(registers, from.at) : read<std::uint32_t>(from.at);
        std::uint32_t& to = register_of(registers, read<std::uint8_t>(at) >> 3 & 7);
        to = is_wide ? value : (to & 0xffff0000u) | (value & 0xffff);
    }
    registers.eip = at + from.size;
}

// Calls use(constant) for one of the eight floating-point registers, whose numbers are part of instructions.
template <int kNumber = 0>
void with_number(std::uint32_t number, const auto& use) {
    if (number == kNumber) return use(std::integral_constant<int, kNumber>());
    if constexpr (kNumber < 7) with_number<kNumber + 1>(number, use);
}

// FUCOMI and its variants: compare the top of the floating-point stack with another register, and may pop it.
void compare_floats(std::uint32_t number, bool pops, Registers& registers) {
    std::uint16_t status = 0;
    with_number(number, [&](auto constant) {
        asm volatile("fucom %%st(%c1); fnstsw %0" : "=a"(status) : "i"(decltype(constant)::value));
    });
    if (pops) asm volatile("fstp %st(0)");
    // Bits 8, 10 and 14 of the status are bits 0, 2 and 6 of the flags.
    constexpr std::uint32_t kCompared = kCarry | kParity | kZero;
    registers.flags = (registers.flags & ~(kCompared | kSign | kOverflow)) | (status >> 8 & kCompared);
    registers.eip += 2;
}

// FCMOV: copies another register of the floating-point stack to its top.
void move_float_if(std::uint32_t condition, std::uint32_t number, Registers& registers) {
    registers.eip += 2;
    if (!holds(condition, registers.flags)) return;
    with_number(number, [](auto constant) {
        if constexpr (constant != 0) asm volatile("fld %%st(%c0); fstp %%st(1)" : : "i"(decltype(constant)::value));
    });
}

bool emulate_at(std::uint32_t at, bool is_wide, Registers& registers) {
    const std::uint8_t first = read<std::uint8_t>(at), second = read<std::uint8_t>(at + 1);
    if ((first == 0xdb || first == 0xdf) && second >= 0xe8 && second < 0xf8) {
        compare_floats(second & 7, first == 0xdf, registers);
        return true;
    }
    if ((first == 0xda || first == 0xdb) && second >= 0xc0 && second < 0xe0) {
        constexpr std::uint32_t kConditions[] = {2, 4, 6, 10};  // below, equal, below or equal, unordered
        move_float_if(kConditions[second >> 3 & 3] + (first == 0xdb), second & 7, registers);
        return true;
    }
    if (first != 0x0f) return false;
    if (second >= 0x40 && second < 0x50) {
        move_if(second & 15, at + 2, is_wide, registers);
        return true;
    }
    if (second != 0x1e && second != 0x1f) return false;  // NOPs; among them ENDBR32
    registers.eip = at + 2 + operand_at(at + 2, registers).size;
    return true;
}

}  // namespace

bool emulate(Registers& registers) {
    std::uint32_t at = registers.eip;
    bool is_wide = true;
    for (;; ++at) {
        const std::uint8_t prefix = read<std::uint8_t>(at);
        if (prefix == 0x66)
            is_wide = false;
        else if (prefix != 0xf3 && prefix != 0x2e && prefix != 0x3e)
            break;
    }
    if (!emulate_at(at, is_wide, registers)) return false;
    ++emulated;
    return true;
}

std::uint32_t emulated_instructions() {
    return emulated;
}

}  // namespace oblong::dos
