; Operands in memory, in the addressing modes that programs use: pointers that advance, fields of a record, variables.
TURNS = 20000.
LENGTH = 1000.
        . = 1000
start:  mov     #TURNS, r5
1$:     mov     #source, r1
        mov     #target, r2
        mov     #record, r3
2$:     mov     (r1)+, r0
        add     2(r3), r0
        mov     r0, (r2)+
        add     r0, sum
        inc     4(r3)
        cmp     r0, limit
        blt     3$
        mov     r0, @#most
3$:     bit     #1, (r2)
        beq     4$
        clr     6(r3)
4$:     cmp     r1, #source + LENGTH + LENGTH
        blo     2$
        dec     r5
        bne     1$
        halt
sum:    .word   0
limit:  .word   100
most:   .word   0
record: .word   1, 2, 3, 4
        . = 4000
source: .blkw   LENGTH
target: .blkw   LENGTH + 1
        .end    start
