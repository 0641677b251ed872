; Loops for ever.
        . = 1000
start:  br      start
        .end    start
