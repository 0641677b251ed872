; Node 0 gives back more credit than there is.
        . = 1000
start:  mov     #1, r0
        mov     #-17., @#165012
        halt
        .end    start
