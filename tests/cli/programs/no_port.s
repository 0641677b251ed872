; Sends through a port that is not there.
        . = 1000
start:  mov     #1000, r3
        mov     r3, @#164362            ; TXADDR of port 17
        mov     #2, @#164364            ; TXLEN: sends
        halt
        .end    start
