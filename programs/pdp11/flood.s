; A word from node 0 reaches everyone: each node passes on the first copy through all its ports and drops the rest.
;
; Message: byte 0 its kind (1), byte 1 the hops taken so far.
; Registers: r0 the first register of a port; r1 ports left to serve; r2 scratch.

PORT    = 164000                ; first port; a port every 020
TXADDR  = 2                     ; offsets in a port
TXLEN   = 4
RXADDR  = 14
NODE    = 165000
PORTS   = 165002
RXANY   = 165004
WAITFOR = 165006
CREDIT  = 165012
PHASE   = 165014

LENGTH  = 2                     ; bytes of the message
CHANGE  = 140000                ; WAITFOR: a message, or another phase

        . = 1000
start:  mov     #start, sp
        mov     @#PHASE, r2     ; so that WAITFOR sees it change
        tst     @#NODE
        bne     ready
        jsr     pc, flood       ; node 0 has the word
ready:  mov     #-1, @#CREDIT   ; this node makes no more work of its own

wait:   mov     #CHANGE, @#WAITFOR
        mov     @#RXANY, r0
        bmi     phase           ; 177777: no message, so the phase has changed
        ash     #4, r0
        add     #PORT, r0
        mov     #buffer, RXADDR(r0)
        tst     seen
        bne     drop
        jsr     pc, flood
drop:   mov     #-1, @#CREDIT   ; the copy is consumed, and what follows from it is counted
        br      wait

phase:  halt                    ; one phase, one frame: nothing is left to do

; Sends the word through every port, one credit a copy.
flood:  mov     #1, seen
        incb    buffer+1
        mov     @#PORTS, r1
        beq     2$
        mov     #PORT, r0
1$:     mov     #1, @#CREDIT
        mov     #buffer, TXADDR(r0)
        mov     #LENGTH, TXLEN(r0)
        add     #20, r0
        sob     r1, 1$
2$:     rts     pc

seen:   .word   0
buffer: .byte   1, 0

        .end    start
