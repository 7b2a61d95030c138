// Loads the game above 1 MB and starts it in protected mode; later returns to real mode. Assembled twice: as
// OBLONG.COM, which reads OBLONG.SYS through DOS, and (FROM_DISK) as the sectors after the disk image's first one,
// which read the same bytes through the BIOS. In both cases it is at offset 0x100 of its segment, and the 64 KB from cs
// + 0x1000 are free.
//
// A PC starts in real mode: addresses are segment * 16 + offset, up to 1 MB. The BIOS copies data to memory above that
// (INT 15h, AH=87h). Protected mode has 32-bit offsets; the BIOS and DOS cannot be called there.
#include "engine/platform/dos/layout.h"

#define PIECE 32768                 // bytes read at a time

    // After this macro, code runs in protected mode, with all memory as its data.
    .macro ENTER_PROTECTED_MODE
    lgdtl gdtr
    movl %cr0, %eax
    orb $1, %al
    movl %eax, %cr0
    ljmpl $0x28, $1f                // 32-bit code of this segment
    .code32
1:  movw $0x10, %ax
    movw %ax, %ds
    movw %ax, %es
    movw %ax, %ss
    movw %ax, %fs
    movw %ax, %gs
    .endm

    .code16
    .globl _start
_start:
    jmp begin
    // The words after OBLONG on a DOS command line. In a disk image they may be written here.
    .ascii "ARGUMENTS:"
words: .byte 13
    .skip 100
begin:
    cld
    movw %cs, %ax
    movw %ax, %ds
    movw %ax, %es
#ifdef FROM_DISK
    movw %ax, %ss
    movw $0xfffe, %sp
    movb %dl, drive
#else
    movw $text_memory, %si
    addw $0x2000, %ax
    cmpw 2, %ax                     // the end of DOS memory, from the program segment prefix
    ja fail
#endif
    movw $text_v86, %si
    smsww %ax                       // already in protected mode: another program controls it
    testb $1, %al
    jnz fail
    movw $text_486, %si
    call has_486
    jz fail
    call open_a20
    call open_file
    jc fail
    call set_bases
#ifndef FROM_DISK
    movw $0x2524, %ax
    movw $critical_error, %dx
    int $0x21
    call check_memory
#endif

next_piece:
    call read_piece
    jc fail
    orw %ax, %ax
    jz loaded
    movw %ax, %cx
    pushw %ax
    shrw $1, %cx                    // words
    movw $bios_gdt, %si
    movb $0x87, %ah
    int $0x15
    popw %cx
    movw $text_memory, %si
    jc fail
    movzwl %cx, %ecx
    movl copy_to, %eax
    addl %ecx, %eax
    call set_copy_to
    jmp next_piece

loaded:
    movw $0x0013, %ax               // 320x200 pixels of 256 colours
    int $0x10
    movw %sp, saved_sp
    movl base, %ebx
    addl $boot_info, %ebx
    cli
    ENTER_PROTECTED_MODE
    ljmpl $0x08, $KERNEL_ADDRESS    // ebx: boot_info
    .code16

// The kernel jumps here when the game has ended: in protected mode, in a 16-bit segment.
leave:
    movw $0x20, %ax
    movw %ax, %ds
    movw %ax, %es
    movw %ax, %ss
    movw %ax, %fs
    movw %ax, %gs
    movl %cr0, %eax
    andb $0xfe, %al
    movl %eax, %cr0
    .byte 0xea                      // only a far jump loads cs for real mode
    .word in_real_mode
leave_segment: .word 0
in_real_mode:
    movw %cs, %ax
    movw %ax, %ds
    movw %ax, %es
    movw %ax, %ss
    movzwl saved_sp, %esp
    lidtl real_idt                  // interrupts through the table at address 0 again
    sti
#ifndef FROM_DISK
    cmpb $0, dos_is_asked
    jne ask_dos
#endif
    movw $0x0003, %ax               // text of 80x25
    int $0x10
    movw $message, %si
    call print
#ifdef FROM_DISK
    movw $text_end, %si
fail:
    call print
    xorb %ah, %ah
    int $0x16                       // waits for a key
    ljmp $0xffff, $0                // restarts the PC
#else
    movb exit_code, %al
    jmp exit
fail:
    call print
    movb $1, %al
exit:
    movb $0x4c, %ah
    int $0x21
#endif

#ifndef FROM_DISK
// Makes a DOS call for the kernel (DosCall of kernel/kernel.h), which continues at dos_resume.
ask_dos:
    movb $0, dos_is_asked
    movw dos_bx, %bx
    movw dos_cx, %cx
    movw dos_dx, %dx
    movw dos_di, %di
    movw dos_ax, %ax
    movw buffer, %es
    pushw %ds
    movw buffer, %ds
    int $0x21
    popw %ds
    movw %ax, dos_ax
    sbbw %ax, %ax
    movw %ax, dos_has_failed
    cli
    ENTER_PROTECTED_MODE
    ljmpl *%cs:dos_resume
    .code16

// If the driver of extended memory (XMS) has allocated any, for example for a disk cache, DOS is not called after the
// game has overwritten it. Memory of the expanded-memory driver's own handle 0 does not count: DOSBox has 128 KB there.
check_memory:
    movw $0x4300, %ax
    int $0x2f
    cmpb $0x80, %al
    jne 1f
    pushw %es
    movw $0x4310, %ax
    int $0x2f
    movw %bx, xms_driver
    movw %es, xms_driver + 2
    popw %es
    movb $8, %ah                    // dx: free KB
    lcall *xms_driver
    xorw %ax, %ax
    movw %ax, %fs
    cmpl $0, %fs:0x67 * 4
    je 2f
    pushw %dx
    xorw %dx, %dx
    movb $0x4c, %ah                 // bx: the pages of handle dx, 16 KB each
    int $0x67
    popw %dx
    testb %ah, %ah
    jnz 2f
    shlw $4, %bx
    addw %bx, %dx
2:
    movb $0x31, %al                 // the total KB, from the CMOS memory
    outb %al, $0x70
    inb $0x71, %al
    movb %al, %ch
    movb $0x30, %al
    outb %al, $0x70
    inb $0x71, %al
    movb %al, %cl
    addw $64, %dx                   // used by DOS itself
    jc 1f
    cmpw %cx, %dx
    jae 1f
    movl $0, info_dos
1:  ret

critical_error:                     // without this, DOS would ask for a retry, as text over the picture: fails the call
    movb $3, %al
    iret
#endif

print:                              // si: a text that ends with 0
    lodsb
    orb %al, %al
    jz 1f
    movb $0x0e, %ah
    movw $7, %bx
    int $0x10
    jmp print
1:  ret

has_486:                            // not zero: flag AC (bit 18) of the 486 can be changed
    pushfl
    popl %eax
    movl %eax, %ecx
    xorl $0x40000, %eax
    pushl %eax
    popfl
    pushfl
    popl %eax
    pushl %ecx
    popfl
    xorl %ecx, %eax
    testl $0x40000, %eax
    ret

open_a20:                           // otherwise address line 20 is held at 0, as on an 8086
    movw $0x2401, %ax
    int $0x15
    inb $0x92, %al
    orb $2, %al
    andb $0xfe, %al                 // bit 0 would restart the PC
    outb %al, $0x92
    ret

set_bases:                          // stores this segment's address where it is needed
    movw %cs, %ax
    movw %ax, leave_segment
    addw $0x1000, %ax
    movw %ax, buffer
    movzwl %ax, %eax
    shll $4, %eax
    movl %eax, info_buffer
    movl %eax, bios_gdt + 18
    movb $0x93, bios_gdt + 21
    xorl %eax, %eax
    movw %cs, %ax
    shll $4, %eax
    movl %eax, base
    addl %eax, gdtr + 2
    addl %eax, info_gdtr
    addl %eax, info_words
    addl %eax, info_message
    addl %eax, info_exit_code
#ifndef FROM_DISK
    addl %eax, info_dos
#endif
    orl %eax, gdt + 0x18 + 2
    orl %eax, gdt + 0x20 + 2
    orl %eax, gdt + 0x28 + 2
    movl $KERNEL_ADDRESS, %eax
set_copy_to:                        // eax: the address for the next piece
    movl %eax, copy_to
    movl %eax, bios_gdt + 26
    movb $0x93, bios_gdt + 29
    ret

#ifdef FROM_DISK
// Sectors are addressed by cylinder, head and sector, which every BIOS supports.
open_file:
    movb $8, %ah                    // the drive's geometry
    movb drive, %dl
    pushw %es
    int $0x13
    popw %es
    movw $text_disk, %si
    jc 1f
    andw $0x3f, %cx
    movw %cx, sectors
    movb %dh, %cl
    xorb %ch, %ch
    incw %cx
    movw %cx, heads
    xorw %ax, %ax                   // the boot sector is still in memory
    movw %ax, %fs
    movl %fs:0x7c00 + 440, %eax
    movl %eax, end_sector
    clc
1:  ret

read_piece:                         // ax: bytes, up to the end of a track; 0: all has been read. Carry: text in si
    movl sector, %eax
    cmpl end_sector, %eax
    jb 1f
    xorw %ax, %ax
    ret
1:  xorl %edx, %edx
    movzwl sectors, %ecx
    divl %ecx                       // eax: track, edx: sector in it
    movw %cx, %bx
    subw %dx, %bx
    cmpw $PIECE / 512, %bx
    jbe 2f
    movw $PIECE / 512, %bx
2:  movw %bx, count
    incw %dx
    movw %dx, %si
    xorl %edx, %edx
    movzwl heads, %ecx
    divl %ecx                       // eax: cylinder, edx: head
    movb %dl, %dh
    movw %si, %cx
    movb %al, %ch
    shlb $6, %ah
    orb %ah, %cl
    movb drive, %dl
    movb count, %al
    movb $2, %ah
    movw buffer, %bx
    pushw %es
    movw %bx, %es
    xorw %bx, %bx
    int $0x13
    popw %es
    movw $text_disk, %si
    jc 3f
    movzwl count, %eax
    addl %eax, sector
    shlw $9, %ax
    clc
3:  ret
#else
open_file:
    movw $0x3d00, %ax
    movw $file_name, %dx
    int $0x21
    movw %ax, handle
    movw $text_file, %si
    ret

read_piece:                         // ax: bytes; 0: all has been read. Carry: text in si
    movw handle, %bx
    movw buffer, %ax
    movw %ax, %ds
    movb $0x3f, %ah
    movw $PIECE, %cx
    xorw %dx, %dx
    int $0x21
    pushw %cs
    popw %ds
    movw $text_file, %si
    ret
#endif

    .balign 8
gdt:                                // segments: limit, base, kind
    .quad 0
    .quad 0x00cf9a000000ffff        // 0x08: all memory, code of 32 bits
    .quad 0x00cf92000000ffff        // 0x10: all memory, data
    .quad 0x00009a000000ffff        // 0x18: this segment, code of 16 bits
    .quad 0x000092000000ffff        // 0x20: this segment, data
    .quad 0x00409a000000ffff        // 0x28: this segment, code of 32 bits
gdtr: .word 47
    .long gdt
real_idt: .word 0x3ff
    .long 0
bios_gdt:                           // descriptors for the BIOS's copy: from (at 16), to (at 24)
    .quad 0, 0
    .quad 0xffff, 0xffff, 0, 0

    .balign 4
boot_info:                          // BootInfo of kernel/kernel.h
info_gdtr: .long gdtr
    .long leave
info_words:
#ifdef FROM_DISK
    .long words
#else
    .long 0x81                      // in the program segment prefix
#endif
info_message: .long message
    .long message_end - message
info_exit_code: .long exit_code
#ifdef FROM_DISK
info_dos: .long 0
#else
info_dos: .long dos_call
#endif
info_buffer: .long 0

base: .long 0
copy_to: .long 0
saved_sp: .word 0
buffer: .word 0
exit_code: .byte 0
#ifdef FROM_DISK
drive: .byte 0
    .balign 4
sector: .long 8
end_sector: .long 0
sectors: .word 0
heads: .word 0
count: .word 0
text_disk: .asciz "The disk can't be read.\r\n"
text_end: .asciz "Switch off, or press a key to start again.\r\n"
#else
dos_call:                           // DosCall
dos_resume: .long 0
    .word 0x08
dos_ax: .word 0
dos_bx: .word 0
dos_cx: .word 0
dos_dx: .word 0
dos_di: .word 0
dos_has_failed: .word 0
dos_is_asked: .byte 0
xms_driver: .long 0
handle: .word 0
file_name: .asciz "OBLONG.SYS"
text_file: .asciz "OBLONG.SYS can't be read: it belongs into the current folder, as OBLONG.COM.\r\n"
#endif
text_v86: .asciz "Oblong needs the processor in real mode: start DOS without EMM386 and Windows.\r\n"
text_486: .asciz "Oblong needs a 486 or a later processor.\r\n"
text_memory: .asciz "There is too little memory: 640 KB and 15 MB above 1 MB are enough.\r\n"
message: .skip 600
message_end:
