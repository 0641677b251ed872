; SPDX-License-Identifier: MIT
; Over the screen from owner to owner (topologies/walk.hpp). A message carries the path it is on, three bits a hop with the
; next one lowest, ones behind; where the path is used up the processor looks at the pixel and gives it the next one.

; Takes the next hop of the path in r5's message. Clobbers r0, r3.
follow: mov     t_path(r5), r3
        mov     r3, r0
        ash     #-3, r0                 ; ones move in
        mov     r0, t_path(r5)
        bic     #177770, r3
        asl     r3
        jmp     send

; The same for a copy of the message, which stays the caller's.
follow_copy:
        mov     t_path(r5), r3
        mov     r3, r0
        ash     #-3, r0
        mov     r0, t_path(r5)
        bic     #177770, r3
        asl     r3
        jmp     send_copy

; In: r0 a row of the screen. Out: r4 its record, or 0 and r0 a path towards it. Flags as of r4.
find_row:
        sub     top_row, r0
        blt     1$
        cmp     r0, row_count
        bge     2$
        ash     #4, r0
        add     row_table, r0
        mov     r0, r4
        return
1$:     mov     path_up, r0
        clr     r4
        return
2$:     mov     path_down, r0
        clr     r4
        return

; In: r5 a triangle whose path is used up. Out: r0 its next path, in the message, too; or 0: its pixel is here.
; Clobbers r1, r4.
walk_step:
        movb    t_y(r5), r0
        bic     #177400, r0
        call    find_row
        beq     2$
        movb    t_x(r5), r1
        bic     #177400, r1
        sub     w_first(r4), r1
        bge     1$
        add     screen_width, r1
1$:     cmp     r1, w_length(r4)
        blt     3$
        mov     w_left(r4), r0
        asl     r1
        cmp     r1, screen_width
        bge     2$
        mov     w_right(r4), r0         ; the row closes on itself as the sphere does
2$:     mov     r0, t_path(r5)
        return
3$:     clr     r0
        return
