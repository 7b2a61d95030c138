// The first sector of the disk image. The BIOS reads it to 0x7c00 and jumps there, in real mode, with the drive's
// number in dl. This code reads the loader (loader.S) from the next seven sectors, and jumps to it.
#define LOADER_SEGMENT 0x1000
#define LOADER_SECTORS 7

    .code16
    .globl _start
_start:
    cli
    xorw %ax, %ax
    movw %ax, %ds
    movw %ax, %ss
    movw $0x7c00, %sp
    sti
    cld
    ljmp $0, $1f                    // some BIOSes jump to 0x07c0:0
1:  movb %dl, drive
    movb $5, tries
read:
    movw $LOADER_SEGMENT, %ax
    movw %ax, %es
    movw $0x100, %bx                // as DOS loads a program
    movw $0x0200 + LOADER_SECTORS, %ax
    movw $0x0002, %cx               // cylinder 0, sector 2: sectors are counted from 1
    xorb %dh, %dh
    movb drive, %dl
    int $0x13
    movb drive, %dl
    jnc loaded
    xorb %ah, %ah                   // resets the drive: floppies fail at first, until they reach their speed
    int $0x13
    decb tries
    jnz read
    movw $text, %si
2:  lodsb
    orb %al, %al
    jz 3f
    movb $0x0e, %ah
    int $0x10
    jmp 2b
3:  hlt
    jmp 3b
loaded:
    ljmp $LOADER_SEGMENT, $0x100

text: .asciz "Oblong can't be read from this disk."
drive: .byte 0
tries: .byte 0

    .org 440
    .long 0                         // the sector after the game's last, for the loader: written by game/dos/image.cpp
    // One bootable partition: BIOSes treat a USB stick without one as a floppy.
    .org 446
    .byte 0x80, 0, 2, 0, 0x7f, 0xfe, 0xff, 0xff
    .long 1, 0                      // first sector 1, number of sectors: also written there
    .org 510
    .word 0xaa55
