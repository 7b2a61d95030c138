#pragma once

// Where everything lies in memory, bytes from 0. Also read by the assembler.

// Above the 64 KB that DOS itself may use beyond 1 MB (its "high memory area").
#define KERNEL_ADDRESS 0x110000
#define PROGRAM_ADDRESS 0x120000
#define VGA_ADDRESS 0xa0000
