; Runs off its memory: nothing but no-operations up to the I/O page.
        . = 157770
start:  nop
        nop
        nop
        nop
        .end    start
