; A token goes round a ring LAPS times: what a hop costs when nothing is in its way.
;
; Message: byte 0 its kind (1), byte 1 the hops taken so far, then one word, the laps that are left.
; Registers: r0 the first register of a port; r1 scratch.

PORT    = 164000                ; first port; a port every 020
TXADDR  = 2                     ; offsets in a port
TXLEN   = 4
RXADDR  = 14
NODE    = 165000
RXANY   = 165004
WAITFOR = 165006
CREDIT  = 165012
PHASE   = 165014

LAPS    = 10.
LENGTH  = 4                     ; bytes of the token
CHANGE  = 140000                ; WAITFOR: a message, or another phase

        . = 1000
start:  mov     #start, sp
        mov     @#PHASE, r1     ; so that WAITFOR sees it change
        tst     @#NODE
        bne     ready
        mov     #PORT, r0       ; node 0 starts the token through its port 0
        mov     #1, @#CREDIT
        jsr     pc, send
ready:  mov     #-1, @#CREDIT   ; this node makes no more work of its own

wait:   mov     #CHANGE, @#WAITFOR
        mov     @#RXANY, r0
        bmi     phase           ; 177777: no message, so the phase has changed
        ash     #4, r0
        add     #PORT, r0
        mov     #token, RXADDR(r0)
        incb    token+1
        tst     @#NODE
        bne     pass
        dec     token+2         ; home again: one lap less
        bne     pass
        mov     #-1, @#CREDIT   ; the token is consumed
        br      wait
pass:   mov     #20, r1         ; out of the other port
        xor     r1, r0
        jsr     pc, send
        br      wait

phase:  halt                    ; one phase, one frame: nothing is left to do

; Sends the token through the port at r0.
send:   mov     #token, TXADDR(r0)
        mov     #LENGTH, TXLEN(r0)
        rts     pc

token:  .byte   1, 0
        .word   LAPS

        .end    start
