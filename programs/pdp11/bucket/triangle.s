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
        ble     side'_upper                 ; M-B has none
        dec     r1
        mov     r1, lines_below
        mov     r0, lines
        mov     #side'_again, edge_ended
tap_vertex_'side'_upper:
        edge    side, r5, r4, is_left
        jmp     segment
side'_upper:
        mov     #next_triangle, edge_ended
        br      tap_vertex_'side'_upper
side'_again:
        mov     middle, r4
        mov     bottom, sp
        mov     lines_below, lines
        mov     row, r0
        add     tile_top, r0
        ash     #4, r0
        mov     r0, line_16
side'_lower:
        mov     #next_triangle, edge_ended
tap_vertex_'side'_lower:
        edge    side, r4, sp, is_left
        jmp     segment
        .endm

long_left:
        begin_lines
        clr     middle_is_left
tap_vertex_left_long:
        edge    left, r5, sp, 1
        short_side right, 0

long_right:
        begin_lines
        mov     #-1, middle_is_left
tap_vertex_right_long:
        edge    right, r5, sp, 0
        short_side left, 1
