; Waits for a message that nobody sends, and keeps its credit.
        . = 1000
start:  mov     #100000, @#165006       ; WAITFOR a message
        halt
        .end    start
