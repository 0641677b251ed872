; SPDX-License-Identifier: MIT
; Edges of the triangle being drawn: x, for the long edge also depth and intensity, at the centre line of the current row,
; and what they grow by a row, each with 16 bits of fraction. Both triangles at an edge compute it alike, from its upper end to its lower one, so
; that no pixel between them is drawn twice or left out. An edge's x is kept 31 higher, so that a shift by 6 makes it the first
; column at or right of it.

e_x = 0                         ; value, fraction, growth, fraction of the growth
e_z = 10
e_i = 20

; In: r1 the upper vertex, r2 the lower one, r4 the edge. Out: r0 how many rows of the screen it covers, with flags;
; edge_first the first of them; the edge's x. Clobbers r1 to r3; r4 moves behind x.
set_edge:
        mov     2(r1), r0
        add     #31., r0
        ash     #-6, r0                 ; the first centre line at or below the upper vertex
        bge     1$
        clr     r0                      ; the screen's
1$:     mov     2(r2), r3
        add     #31., r3
        ash     #-6, r3
        cmp     r3, screen_height
        ble     2$
        mov     screen_height, r3
2$:     sub     r0, r3
        ble     3$
        mov     r3, edge_rows
        mov     r0, edge_first
        ash     #6, r0
        add     #32., r0
        sub     2(r1), r0
        mov     r0, skip                ; from the vertex to that line
        mov     2(r2), divisor
        sub     2(r1), divisor
        mov     (r1), r3
        mov     (r2), r2
        call    edge_value
        add     #31., e_x-10(r4)
        mov     edge_rows, r3
3$:     mov     r3, r0
        return

; Depth and intensity of the long edge, right after its set_edge. In: r4 as that left it. Clobbers r0 to r4.
add_values:
        mov     top_vertex, r3
        mov     4(r3), r3
        mov     low_vertex, r2
        mov     4(r2), r2
        call    edge_value
        mov     top_vertex, r3
        mov     6(r3), r3
        add     #64., r3                ; half a grey level: rounds when the fraction is cut off
        mov     low_vertex, r2
        mov     6(r2), r2
        add     #64., r2

; Value r3 at the upper end, r2 at the lower: (r4)+ = value at the first line, and growth. Clobbers r0 to r2.
edge_value:
        sub     r3, r2
        mov     r2, r0
        mul     skip, r0
        div     divisor, r0
        add     r3, r0
        mov     r0, (r4)+
        clr     (r4)+
        cmp     edge_rows, #1
        beq     2$                      ; nothing to step to
        cmp     edge_rows, #short_way
        bgt     1$
        call    short_slope
        mov     r0, (r4)+
        mov     r1, (r4)+
        return
1$:     call    slope
        mov     r0, (r4)+
        mov     r1, (r4)+
        return
2$:     add     #4, r4
        return

; r0 and fraction r1 = 64 r2 / divisor, which is above 64. Over a short way six bits of fraction are enough, which one
; division yields unless the growth is steep. Clobbers r2.
short_way = 16.                 ; steps

short_slope:
        mov     r2, r1
        sxt     r0
        ashc    #12., r0
        div     divisor, r0
        bvs     slope
        clr     r1
        ashc    #-6, r0
        return
slope:  mov     r2, r1
        sxt     r0
        ashc    #6, r0
        div     divisor, r0
        mov     r0, r2
        mov     r1, r0                  ; the remainder
        clr     r1
        ashc    #-1, r0
        div     divisor, r0             ; 15 bits of signed fraction
        asl     r0
        sbc     r2
        mov     r0, r1
        mov     r2, r0
        return
