; SPDX-License-Identifier: MIT
; The course of a frame. Everything that happens begins here: a phase begins, a message is taken in, a piece of local
; work is done, or the processor waits.
;
; Register use throughout: r5 the message in hand, r3 twice a port's number, r0 to r4 otherwise free to any routine.

start:  mov     #stack_top, sp

; A phase has been announced.
next_phase:
        mov     @#io_phase, phase
        bmi     finish                  ; the run is over
        inc     owed
        mov     step, r1
        mov     r1, r2
        add     #2, r2
        cmp     r2, #2*phases_per_frame
        blo     1$
        clr     r2
1$:     mov     r2, step
        call    @begin_phase(r1)

main_loop:
        tst     queue_mask
        beq     1$
        call    pump
1$:     cmp     free_count, #reserve_receive
        blt     2$                      ; nearly full: leave messages in the machine's queues
        mov     @#io_rxany, r3
        bmi     2$
        call    receive
        br      main_loop
2$:     call    work                    ; r0: 1 done some, 0 none left, -1 must wait for room
        tst     r0
        bgt     main_loop
        blt     3$
        tst     owed                    ; nothing left to do: give back the phase's credit
        beq     3$
        clr     owed
        mov     #-1, @#io_credit
3$:     mov     queue_mask, r0
        cmp     free_count, #reserve_receive
        bge     4$
        tst     r0
        bne     5$
        mov     #fault_pool, @#io_fault
4$:     bis     #wait_message+wait_phase, r0
5$:     mov     r0, @#io_waitfor
        cmp     @#io_phase, phase
        beq     main_loop
        br      next_phase

finish: halt

; Local work that can be put off: drawing triangles. In: nothing. Out: r0 as above. Clobbers all.
work:   tst     scanning
        bne     2$
        tst     draw_list
        beq     none
        cmp     step, #step_after_draw  ; the DRAW phase, or the pool runs low: draw already
        beq     1$
        cmp     free_count, #reserve_low
        bge     none
1$:     jmp     begin_triangle
2$:     cmp     free_count, #reserve_generate
        bge     3$
        mov     #-1, r0
        tst     queue_mask
        bne     4$
3$:     jmp     draw_row
4$:     return
none:   clr     r0
        return

step_after_draw = 0                     ; `step` already names the next phase

begin_phase:
        .word   rotate, points, assemble, seek, transfer, draw

; DRAW: the work is in the draw list already.
draw:   return
