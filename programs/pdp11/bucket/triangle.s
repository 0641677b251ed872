; SPDX-License-Identifier: MIT
; A triangle begins: its vertices from the highest to the lowest, its lines in the tile, its sides.
; Of vertices that are as high, T is the first, and B the one after T in the triangle's order.

; T at r5; M and B are the vertices behind it.
        .macro  order t, n, y_n, p, y_p, ?p_is_lower
        mov     #t, r5
        cmp     y_n, y_p
        blt     p_is_lower
        mov     #n, sp
        mov     #p, r4
        jmp     long_left
p_is_lower:
        mov     #p, sp
        mov     #n, r4
        jmp     long_right
        .endm

tap_polygon:
        mov     vertex_0, r0
        mov     vertex_1, r1
        mov     vertex_2, r2
        cmp     r1, r0
        blt     below_0
        cmp     r2, r0
        blt     top_2
        order   vertex_0, vertex_1, r1, vertex_2, r2
below_0:
        cmp     r2, r1
        blt     top_2
        order   vertex_1, vertex_2, r2, vertex_0, r0
top_2:
        order   vertex_2, vertex_0, r0, vertex_1, r1

; The lines from T to B in the tile: the first one in first_line, how many are behind it in r1; back to next_triangle when there is
; none. Then what all triangles begin with.
        .macro  begin_lines ?in_tile, ?above, ?some
        mov     (r5), r0
        add     #17, r0
        ash     #-4, r0
        cmp     r0, tile_top
        bge     in_tile
        mov     tile_top, r0
in_tile:
        mov     (sp), r1
        ash     #-4, r1
        cmp     r1, tile_bottom
        ble     above
        mov     tile_bottom, r1
above:
        sub     r0, r1
        bge     some
        jmp     next_triangle
some:
        mov     r1, lines
        mov     r0, first_line
        mov     r0, r1
        sub     tile_top, r1
        mov     r1, row
        ash     #4, r0
        mov     r0, line_16
        mov     r5, top
        mov     r4, middle
        mov     sp, bottom
        mov     #-1, column
        .endm

; Goes on to the next triangle when the tile is on the outer side of an edge on all lines that are left. In: r0 how far it is outside on
; the present line, the condition codes of its computing; r2 how much that grows a line, at least.
        .macro  drop_if_outside ?outside, ?inside
        ble     inside
        mul     lines, r2
        add     r0, r3
        adc     r2
        bmi     inside
        bne     outside
        tst     r3
        beq     inside
outside:
        jmp     next_triangle
inside:
        .endm

        .macro  drop_if_right_of_tile
        mov     left_x_dy, r2
        mov     left_x, r0
        sub     last_column, r0
        drop_if_outside
        .endm

        .macro  drop_if_left_of_tile
        mov     right_x_dy, r2
        com     r2
        mov     right_x, r0
        neg     r0
        drop_if_outside
        .endm

        .macro  drop_if_beside is_left
        .if ne is_left
        drop_if_right_of_tile
        .iff
        drop_if_left_of_tile
        .endc
        .endm

; The side of the two short edges. T-M is used down to the last line that it reaches, unless it is horizontal, M-B from then on.
        .macro  short_side side, is_left
        mov     (r4), r0
        cmp     r0, (r5)
        beq     side'_lower
        ash     #-4, r0
        sub     first_line, r0          ; lines of T-M behind the first
        blt     side'_lower
        mov     lines, r1
        sub     r0, r1
        ble     side'_upper             ; M-B has none
        dec     r1
        mov     r1, lines_below
        mov     r0, lines
        mov     #side'_again, edge_ended
tap_vertex_'side'_upper:
        edge    side, r5, r4, is_left
        jmp     segment
side'_upper:                            ; T-M is the last edge
        mov     r4, sp
        mov     r5, r4
        br      side'_lower
side'_again:
        mov     middle, r4
        mov     bottom, sp
        mov     lines_below, lines
        mov     row, r0
        add     tile_top, r0
        ash     #4, r0
        mov     r0, line_16
side'_lower:                            ; the edge from r4 to sp is the last
        mov     #next_triangle, edge_ended
tap_vertex_'side'_last:
        edge    side, r4, sp, is_left
        drop_if_beside is_left
        jmp     segment
        .endm

long_left:
        begin_lines
        clr     middle_is_left
tap_vertex_left_long:
        edge    left, r5, sp, 1
        drop_if_beside 1
        short_side right, 0

long_right:
        begin_lines
        mov     #-1, middle_is_left
tap_vertex_right_long:
        edge    right, r5, sp, 0
        drop_if_beside 0
        short_side left, 1
