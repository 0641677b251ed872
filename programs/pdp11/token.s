; A token goes round a ring LAPS times: what a hop costs when nothing is in its way.
;
; Message: byte 0 its kind (1), byte 1 the hops taken so far, then one word, the laps that are left.
; Registers: r0 the first register of a port; r1 scratch.

LAPS    = 10.
LENGTH  = 4                     ; bytes of the token

        .include "include/node.s"

change  = wait_message+wait_phase

        . = 1000
start:  mov     #start, sp
        mov     @#io_phase, r1  ; so that WAITFOR sees it change
        tst     @#io_node
        bne     ready
        mov     #ports_base, r0 ; node 0 starts the token through its port 0
        mov     #1, @#io_credit
        jsr     pc, send
ready:  mov     #-1, @#io_credit ; this node makes no more work of its own

wait:   mov     #change, @#io_waitfor
        mov     @#io_rxany, r0
        bmi     phase           ; 177777: no message, so the phase has changed
        ash     #4, r0
        add     #ports_base, r0
        mov     #token, rxaddr(r0)
        incb    token+1
        tst     @#io_node
        bne     pass
        dec     token+2         ; home again: one lap less
        bne     pass
        mov     #-1, @#io_credit ; the token is consumed
        br      wait
pass:   mov     #20, r1         ; out of the other port
        xor     r1, r0
        jsr     pc, send
        br      wait

phase:  halt                    ; one phase, one frame: nothing is left to do

; Sends the token through the port at r0.
send:   mov     #token, txaddr(r0)
        mov     #LENGTH, txlen(r0)
        rts     pc

token:  .byte   1, 0
        .word   LAPS

        .end    start
