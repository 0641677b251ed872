; Adds one to five and stops.
        . = 1000
start:  mov     #5, r0
        inc     r0
        halt
        .end    start
