; Stops at once: a program for the plug-in instruction set.
start:  nop
        hlt
        .end    start
