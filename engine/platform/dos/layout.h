#pragma once

// The memory map, in bytes. Also read by the assembler.

// Above the "high memory area", the 64 KB beyond 1 MB that DOS may use.
#define KERNEL_ADDRESS 0x110000
#define PROGRAM_ADDRESS 0x120000
#define VGA_ADDRESS 0xa0000
