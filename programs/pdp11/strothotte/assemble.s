; SPDX-License-Identifier: MIT
; ASSEMBLE: the triangles for which the facets held here are responsible. One whose three corners all look away from the
; viewer is dropped; the others wait in out_list for the TRANSFER phase.

assemble:
        doing   mark_assemble
        mov     #1, request_hops
        mov     facet_list, r5
        beq     2$
1$:     mov     r5, facet
        call    facet_triangles
        mov     facet, r5
        mov     b_link(r5), r5
        bne     1$
2$:     return

facet_triangles:
        movb    f_tris(r5), tris_left
        beq     2$
        movb    f_cross(r5), r4
        asl     r4
        asl     r4
        asl     r4
        add     r5, r4
        add     #f_body, r4
        mov     f_id(r5), r0
        call    locate
        mov     r0, own_points
1$:     mov     r4, -(sp)
        call    triangle
        mov     (sp)+, r4
        add     #6, r4
        decb    tris_left
        bne     1$
2$:     return

; The triangle with record r4 of the facet whose points are in block own_points; when a point is missing it is asked for
; and the triangle put off. Clobbers all.
triangle:
        mov     (r4), r0
        call    locate
        beq     1$
        mov     4(r4), r2
        mov     r2, r1
        bic     #177707, r1
        add     own_points, r1
        add     #p_body, r1
        mov     r1, corner1
        ash     #-3, r2
        mov     r2, r3
        bic     #177707, r2
        add     r0, r2
        add     #p_body, r2
        mov     2(r4), r0
        call    locate
        beq     2$
        ash     #-3, r3
        bic     #177707, r3
        add     r0, r3
        add     #p_body, r3
        mov     corner1, r1
        br      emit
1$:     mov     (r4), r0
        br      3$
2$:     mov     2(r4), r0
3$:     jmp     put_off

; Makes the triangle with corners at r1, r2, r3. Clobbers all.
emit:   tst     6(r1)
        bpl     1$
        tst     6(r2)
        bpl     1$
        tst     6(r3)
        bmi     2$                      ; a back surface
1$:     call    get_block
        mov     #kind_triangle, (r5)
        clr     t_path(r5)
        mov     triangle_size, b_length(r5)
        mov     r5, r4
        add     #t_body, r4
        clr     sum_x
        clr     sum_y
        call    copy_corner
        mov     r2, r1
        call    copy_corner
        mov     r3, r1
        call    copy_corner
        call    aim
        cmp     free_count, #reserve_low
        blt     3$
        mov     out_list, b_link(r5)
        mov     r5, out_list
2$:     return
3$:     mov     #-1, arrival_port       ; no room to keep it
        mov     #1, @#io_credit
        jmp     route_triangle

; The point at r1 to (r4)+, its place added to the sums in quarters. Clobbers r0.
copy_corner:
        mov     (r1)+, r0
        mov     r0, (r4)+
        asr     r0
        asr     r0
        add     r0, sum_x
        mov     (r1)+, r0
        mov     r0, (r4)+
        asr     r0
        asr     r0
        add     r0, sum_y
        mov     (r1)+, (r4)+
        mov     (r1), r0
        bic     #100000, r0
        mov     r0, (r4)+
        return

; The pixel at the triangle's centre, brought into the screen, becomes its destination. Clobbers r0 to r4.
aim:    mov     sum_x, r0
        mul     #1365., r0              ; / 48: thirds of quarters of 1/64 pixel
        tst     r0
        bge     1$
        clr     r0
1$:     cmp     r0, last_column
        ble     2$
        mov     last_column, r0
2$:     movb    r0, t_x(r5)
        mov     r0, r1
        mul     column_angle, r1
        add     half_column_angle, r1
        mov     r1, t_phi(r5)
        mov     sum_y, r0
        mul     #1365., r0
        tst     r0
        bge     3$
        clr     r0
3$:     cmp     r0, last_row
        ble     4$
        mov     last_row, r0
4$:     movb    r0, t_y(r5)
        mov     r0, r1
        mul     row_angle, r1
        add     half_row_angle, r1
        mov     r1, t_theta(r5)
        tst     great_circle
        beq     5$
        mov     r1, r0
        call    sin_cos
        mov     sine, r4
        mov     cosine, t_vz(r5)
        mov     t_phi(r5), r0
        call    sin_cos
        mov     cosine, r0
        fmul    r4, r0, r1
        mov     r0, t_vx(r5)
        mov     sine, r0
        fmul    r4, r0, r1
        mov     r0, t_vy(r5)
5$:     return
