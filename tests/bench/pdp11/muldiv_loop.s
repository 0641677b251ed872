; Fixed-point arithmetic: multiply, add, divide, as a linear interpolation does.
TURNS = 300.
        . = 1000
start:  mov     #TURNS, r5
1$:     clr     r4
2$:     mov     r4, r0
        bic     #140000, r0
        mul     #1234., r0
        add     #500., r1
        adc     r0
        div     #20000., r0
        add     r0, r2
        mov     r1, r3
        sob     r4, 2$
        dec     r5
        bne     1$
        halt
        .end    start
