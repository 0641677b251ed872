; Operations of the VLIW, one a line, which fit into fewer bundles.
start:  mov     r1, #3
        ld      r2, 100
        mul     r3, r2, r2, 16
        put     r1
        halt
        .end    start
