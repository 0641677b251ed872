; Two errors, to be told at once.
start:  mov     #1, r9
        bogus   r0
        .end    start
