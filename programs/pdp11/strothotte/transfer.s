; SPDX-License-Identifier: MIT
; TRANSFER: triangles travel to the owner of the pixel at their centre, by angles until near, then over the screen.

transfer:
        doing   mark_route
        tst     pending_top
        beq     1$
        mov     #fault_missing, @#io_fault
1$:     mov     #-1, arrival_port
        mov     out_list, r5
        beq     3$
        clr     out_list
2$:     mov     b_link(r5), -(sp)
        mov     #1, @#io_credit
        call    route_triangle
        mov     (sp)+, r5
        bne     2$
3$:     return

triangle_in:
        doing   mark_route

; Sends the triangle in r5 on its way or keeps it for drawing. Clobbers r0 to r4.
route_triangle:
        tst     t_path(r5)
        bne     1$
        call    route_by_angles
        tst     r3
        bmi     2$
        jmp     send
2$:     mov     #-1, t_path(r5)         ; near: walk from here on
1$:     mov     t_path(r5), r0
        com     r0
        bit     #7, r0
        bne     follow
        call    walk_step               ; the path is used up
        tst     r0
        bne     follow
        mov     draw_list, b_link(r5)
        mov     r5, draw_list
        mov     #-1, @#io_credit
        return
