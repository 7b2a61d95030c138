// The kernel's first instruction, at KERNEL_ADDRESS, and the gates of all interrupts: each pushes its number and jumps
// to the common handler.
    .code32
    .globl _start, gates
    .section .text.start, "ax"
_start:
    movl $stack_end, %esp
    pushl %ebx                      // BootInfo
    call start_kernel

    .text
    .altmacro
.macro GATE number
gate_\number:
    // For the other numbers the processor pushes an error code.
  .if (\number != 8) && ((\number < 10) || (\number > 14)) && (\number != 17)
    pushl $0
  .endif
    pushl $\number
    jmp any_interrupt
.endm
.set i, 0
.rept 48
    GATE %i
  .set i, i + 1
.endr
    GATE 128
any_interrupt:
    pushal
    cld
    pushl %esp                      // Registers
    call interrupt
    addl $4, %esp
    popal
    addl $8, %esp                   // number and code
    iretl

// Jumps to the loader, which returns to resume_from_dos: go_to_dos(LGDT operand, far address).
    .globl go_to_dos, resume_from_dos
go_to_dos:
    pushal
    sgdt kept_segments
    sidt kept_gates
    movw %gs, kept_thread
    movl %esp, kept_stack
    movl 36(%esp), %eax
    movl 40(%esp), %edx
    lgdt (%eax)
    ljmp *(%edx)
resume_from_dos:
    lgdt kept_segments
    lidt kept_gates
    movl kept_stack, %esp
    movw kept_thread, %gs
    popal
    ret

    .section .rodata
.macro ADDRESS number
    .long gate_\number
.endm
gates:
.set i, 0
.rept 48
    ADDRESS %i
  .set i, i + 1
.endr
    ADDRESS 128

    .bss
    .balign 16
kept_segments: .skip 8
kept_gates: .skip 8
kept_stack: .skip 4
kept_thread: .skip 4
    .skip 8192
stack_end:
