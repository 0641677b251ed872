; Registers only, each result feeding the next; 10 instructions a turn, 65 536 turns, TURNS times over.
; The branch goes the same way for long, so that the host's branch predictor is not what is measured.
TURNS = 400.
        . = 1000
start:  mov     #TURNS, r5
        clr     r0
        mov     #1, r1
1$:     clr     r4
2$:     add     r1, r0
        mov     r0, r2
        asl     r2
        sub     r1, r2
        inc     r3
        bic     r3, r2
        xor     r2, r1
        cmp     r4, r5
        bhi     3$
        inc     r1
3$:     sob     r4, 2$
        dec     r5
        bne     1$
        halt
        .end    start
