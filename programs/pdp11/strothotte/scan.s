; SPDX-License-Identifier: MIT
; DRAW: scan conversion of a triangle, one row at a time so that messages are taken in between rows. A pixel belongs to the
; triangle when its centre does, left and top edges included.
;
; The long edge runs from the top vertex to the lowest; the short edge from the top one to the middle one, then from there
; to the lowest. Depth and intensity are followed along the long edge only; from there to a pixel they change as they do
; over the triangle's greatest width, which is at the height of its middle vertex.

; The long edge one row down.
        .macro  step_long
        .irp    v, <e_x, e_z, e_i>
        add     long_edge+v+6, long_edge+v+2
        adc     long_edge+v
        add     long_edge+v+4, long_edge+v
        .endr
        .endm

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
        bgt     3$
        jmp     end_triangle            ; no row's centre line crosses it
3$:     mov     edge_first, r0
        sub     top_row, r0
        mov     r0, own_row
        ash     #4, r0
        add     row_table, r0
        mov     r0, row_record
        clr     steps_due
        call    add_values
        call    measure
        clr     lower_half
        mov     top_vertex, r1
        mov     middle_vertex, r2
        br      set_short_edge

; Makes the span of the current row. Out: r0 = 1. Clobbers all.
draw_row:
        doing   mark_scan
        mov     long_edge, r3           ; left and
        mov     short_edge, r4          ; right end
        cmp     r3, r4
        ble     1$
        mov     r4, r3
        mov     long_edge, r4
1$:     ash     #-6, r3                 ; first column: that of the first centre at or right of the left end
        bge     2$
        clr     r3
2$:     ash     #-6, r4                 ; last column: that of the last centre left of the right end
        cmp     r4, screen_width
        ble     3$
        mov     screen_width, r4
3$:     dec     r4
        cmp     r3, r4
        bgt     4$
        call    draw_span
4$:     inc     own_row
        add     #16., row_record
        dec     rows_left
        beq     begin_lower
        add     short_edge+6, short_edge+2
        adc     short_edge
        add     short_edge+4, short_edge
        step_long
next_row:
        tst     queue_mask
        bne     5$
        tst     @#io_rxany
        bmi     draw_row                ; no message to see to
5$:     mov     #1, r0
        return

; The upper half is done: the short edge turns at the middle vertex.
begin_lower:
        tst     lower_half
        bne     end_triangle
        inc     lower_half
        mov     middle_vertex, r1
        mov     low_vertex, r2
set_short_edge:
        mov     #short_edge, r4
        call    set_edge
        mov     r0, rows_left
        ble     begin_lower             ; no row: the next half, or the end
        tst     steps_due
        beq     1$                      ; the long edge stands there already
        step_long
1$:     inc     steps_due
        br      next_row

end_triangle:
        mov     scanning, r5
        clr     scanning
        call    free_block
        mov     #1, r0
        return
