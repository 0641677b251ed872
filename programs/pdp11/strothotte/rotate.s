; SPDX-License-Identifier: MIT
; ROTATE: a new frame begins. All facets turn by the same angle about the axis: only their virtual longitude changes. Those
; which now point at another processor travel there, hop by hop.

rotate: doing   mark_clear
        call    clear_pixels
        call    forget_points
        doing   mark_rotate
        call    turn
        mov     #-1, arrival_port
        mov     facet_list, r5
        beq     2$
        clr     facet_list
1$:     mov     b_link(r5), -(sp)
        add     turned_by, f_phi(r5)
        clrb    m_hops(r5)
        tst     great_circle
        beq     3$
        call    facet_direction
3$:     call    route_facet             ; r3
        tst     r3
        bmi     4$
        mov     #1, @#io_credit
        call    send
        br      5$
4$:     mov     facet_list, b_link(r5)
        mov     r5, facet_list
5$:     mov     (sp)+, r5
        bne     1$
2$:     return

; A facet arrives, to stay or to go on.
facet_in:
        doing   mark_route
        call    route_facet
        tst     r3
        bmi     1$
        jmp     send
1$:     mov     facet_list, b_link(r5)
        mov     r5, facet_list
        mov     #-1, @#io_credit
        return

; turned_by = this frame's turn, so that all frames together make the exact sum, rounded.
turn:   mov     turn_total, r0
        add     turn_step+2, turn_total+2
        adc     turn_total
        add     turn_step, turn_total
        mov     turn_total, turned_by
        sub     r0, turned_by
        mov     turn_next, turn_step
        mov     turn_next+2, turn_step+2
        return

; Where the facet in r5 points, as a vector: only great-circle routing asks. Clobbers r0 to r3.
facet_direction:
        mov     f_phi(r5), r0
        call    sin_cos
        mov     cosine, r0
        fmul    f_sin(r5), r0, r1
        mov     r0, f_x(r5)
        mov     sine, r0
        fmul    f_sin(r5), r0, r1
        mov     r0, f_y(r5)
        return

; Depth to farthest, grey to the background, eight words at a time. Clobbers r0, r1, r2.
clear_pixels:
        mov     depth_start, r0
        mov     depth_groups, r1
        beq     2$
        mov     #77777, r2
        call    1$                      ; the depths, then on to the grey levels
        mov     grey_start, r0
        mov     grey_groups, r1
        mov     background, r2
1$:     .rept   8.
        mov     r2, (r0)+
        .endr
        sob     r1, 1$
2$:     return
