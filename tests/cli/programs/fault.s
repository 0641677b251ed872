; Gives up with a code of its own.
        . = 1000
start:  mov     #42, @#165020
        halt
        .end    start
