; Reads a word from an odd address.
        . = 1000
start:  mov     #1001, r1
        mov     (r1), r2
        halt
        .end    start
