; SPDX-License-Identifier: MIT
; DRAW: scan conversion of a triangle, one row at a time so that messages are taken in between rows. A pixel belongs to the
; triangle when its centre does, left and top edges included. The long edge runs from the top vertex to the lowest; the
; short edge from the top one to the middle one, then from there to the lowest.

; Takes a triangle from the draw list. Out: r0 = 1. Clobbers all.
begin_triangle:
        doing   mark_scan
        mov     draw_list, r5
        mov     b_link(r5), draw_list
        mov     r5, scanning
        mov     r5, r1
        add     #t_body, r1
        mov     r1, r2
        add     #8., r2
        mov     r2, r3
        add     #8., r3
        cmp     2(r1), 2(r2)            ; sort by y
        ble     1$
        mov     r1, r0
        mov     r2, r1
        mov     r0, r2
1$:     cmp     2(r2), 2(r3)
        ble     2$
        mov     r2, r0
        mov     r3, r2
        mov     r0, r3
        cmp     2(r1), 2(r2)
        ble     2$
        mov     r1, r0
        mov     r2, r1
        mov     r0, r2
2$:     mov     r1, top_vertex
        mov     r2, middle_vertex
        mov     r3, low_vertex
        mov     r3, r2
        mov     #long_edge, r4
        call    set_edge
        ble     end_triangle            ; no row's centre line crosses it
        mov     edge_first, row
        mov     edge_first, first_row
        clr     lower_half
        mov     top_vertex, r1
        mov     middle_vertex, r2
        mov     #short_edge, r4
        call    set_edge
        mov     r0, rows_left
        bgt     next_row
        br      begin_lower

; Makes the span of the current row. Out: r0 = 1. Clobbers all.
draw_row:
        doing   mark_scan
        mov     #long_edge, r3
        mov     #short_edge, r4
        cmp     (r3), (r4)
        ble     1$
        mov     r3, r0
        mov     r4, r3
        mov     r0, r4
1$:     mov     (r3), r1                ; first column: that of the first centre at or right of the left edge
        add     #31., r1
        ash     #-6, r1
        bge     2$
        clr     r1
2$:     mov     (r4), r2                ; last column: that of the last centre left of the right edge
        add     #31., r2
        ash     #-6, r2
        dec     r2
        cmp     r2, last_column
        ble     3$
        mov     last_column, r2
3$:     cmp     r1, r2
        bgt     4$
        call    make_span
4$:     inc     row
        dec     rows_left
        beq     begin_lower
        mov     #long_edge, r4
        call    step_edge
        mov     #short_edge, r4
        call    step_edge
next_row:
        mov     #1, r0
        return

; The upper half is done: the short edge turns at the middle vertex.
begin_lower:
        tst     lower_half
        bne     end_triangle
        inc     lower_half
        mov     middle_vertex, r1
        mov     low_vertex, r2
        mov     #short_edge, r4
        call    set_edge
        ble     end_triangle
        mov     r0, rows_left
        cmp     row, first_row
        beq     next_row                ; the first half had no row, the long edge stands right
        mov     #long_edge, r4
        call    step_edge
        br      next_row

end_triangle:
        mov     scanning, r5
        clr     scanning
        call    free_block
        br      next_row

; The span of this row from column r1 to r2, between the edges r3 (left) and r4 (right). Clobbers all.
make_span:
        call    get_block
        mov     #kind_span, (r5)
        mov     #-1, s_path(r5)
        movb    row, s_y(r5)
        movb    r1, s_first(r5)
        movb    r2, s_last(r5)
        mov     #s_size, b_length(r5)
        mov     r2, span_more
        sub     r1, span_more           ; pixels behind the first
        ash     #6, r1
        add     #32., r1
        sub     (r3), r1
        mov     r1, skip                ; from the left edge to the first centre
        mov     (r4), divisor
        sub     (r3), divisor
        mov     e_z(r4), r2
        sub     e_z(r3), r2
        mov     r2, r0
        mul     skip, r0
        div     divisor, r0
        add     e_z(r3), r0
        mov     r0, s_z(r5)
        clr     s_z+2(r5)
        tst     span_more
        beq     1$
        call    slope
        mov     r2, s_dz(r5)
        mov     r0, s_dz+2(r5)
1$:     mov     e_i(r4), r2
        sub     e_i(r3), r2
        mov     r2, r0
        mul     skip, r0
        div     divisor, r0
        add     e_i(r3), r0
        asl     r0
        add     #200, r0                ; rounds when the low byte is cut off
        mov     r0, s_i(r5)
        tst     span_more
        beq     2$
        mov     r2, r1                  ; growth a pixel, twice 64 times the difference over the width
        sxt     r0
        ashc    #7, r0
        div     divisor, r0
        bvc     3$
        mov     r2, r1                  ; steeper than 127 levels a pixel
        sxt     r0
        ashc    #6, r0
        div     divisor, r0
        asl     r0
3$:     mov     r0, s_di(r5)
2$:     mov     #1, @#io_credit
        jmp     span_here
