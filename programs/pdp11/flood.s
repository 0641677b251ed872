; A word from node 0 reaches everyone: each node passes on the first copy through all its ports and drops the rest.
;
; Message: byte 0 its kind (1), byte 1 the hops taken so far.
; Registers: r0 the first register of a port; r1 ports left to serve; r2 scratch.

LENGTH  = 2                     ; bytes of the message

        .include "include/node.s"

change  = wait_message+wait_phase

        . = 1000
start:  mov     #start, sp
        mov     @#io_phase, r2  ; so that WAITFOR sees it change
        tst     @#io_node
        bne     ready
        jsr     pc, flood       ; node 0 has the word
ready:  mov     #-1, @#io_credit ; this node makes no more work of its own

wait:   mov     #change, @#io_waitfor
        mov     @#io_rxany, r0
        bmi     phase           ; 177777: no message, so the phase has changed
        ash     #4, r0
        add     #ports_base, r0
        mov     #buffer, rxaddr(r0)
        tst     seen
        bne     drop
        jsr     pc, flood
drop:   mov     #-1, @#io_credit ; the copy is consumed, and what follows from it is counted
        br      wait

phase:  halt                    ; one phase, one frame: nothing is left to do

; Sends the word through every port, one credit a copy.
flood:  mov     #1, seen
        incb    buffer+1
        mov     @#io_ports, r1
        beq     2$
        mov     #ports_base, r0
1$:     mov     #1, @#io_credit
        mov     #buffer, txaddr(r0)
        mov     #LENGTH, txlen(r0)
        add     #20, r0
        sob     r1, 1$
2$:     rts     pc

seen:   .word   0
buffer: .byte   1, 0

        .end    start
