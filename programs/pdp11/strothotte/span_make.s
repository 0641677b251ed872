; SPDX-License-Identifier: MIT
; The span of a row of the triangle being drawn: depth and intensity at its first pixel, and what they grow by a pixel.
; Intensities stay within those of the vertices, so that they never wrap: where they are steep, the growth is taken
; from the span's own two ends.

quick_reach = 512.              ; 1/64 pixel: so far left of the long edge a rounded growth is good enough
steepest = 4096.                ; 8.8 a pixel: with less, a shift by 1/64 pixel stays within the rounding

; The span from column r3 to r4 of the current row: draws what is this processor's, hands over the rest. Clobbers all.
draw_span:
        mov     #row_span, r5
        tst     quick
        beq     slow_start
        mov     r3, r2
        ash     #6, r2
        add     #63., r2
        sub     long_edge, r2           ; from the long edge to the first pixel's centre
        cmp     r2, #63.
        bgt     slow_start              ; cut off by the screen
        cmp     r2, #-quick_reach
        blt     slow_start
        mov     r2, r0
        mul     whole_z, r0
        ashc    #-6, r0
        add     long_edge+e_z, r1
        mov     r1, s_z(r5)
        clr     s_z+2(r5)
        mov     r2, r0
        mul     pixel_i, r0
        ashc    #-6, r0
        add     long_edge+e_i, r1
        add     long_edge+e_i, r1
        mov     r1, s_i(r5)
started:
        mov     r3, r1
        mov     r4, r2
        cmp     own_row, row_count
        bhis    foreign_row
        mov     row_record, r4
        cmp     r1, w_first(r4)
        blt     1$
        cmp     r2, w_last(r4)
        bgt     1$
        jmp     plot                    ; all of it is this processor's
1$:     call    name_row
        mov     w_left(r4), r0
        cmp     r2, w_first(r4)
        blt     span_off
        mov     w_right(r4), r0
        cmp     r1, w_last(r4)
        bgt     span_off
        call    split
        bne     span_off
        return

foreign_row:
        call    name_row
        mov     path_up, r0
        tst     own_row
        bmi     span_off
        mov     path_down, r0
span_off:
        mov     r0, s_path(r5)
        mov     #1, @#io_credit
        jmp     follow_copy

; Row and columns r1 to r2 into the row's span. Clobbers r0.
name_row:
        mov     own_row, r0
        add     top_row, r0
        movb    r0, s_y(r5)
        movb    r1, s_first(r5)
        movb    r2, s_last(r5)
        return

; The start by division: where the growth is not known or the first pixel is far from the long edge.
slow_start:
        mov     across, divisor
        sub     r3, r4                  ; pixels behind the first
        call    from_long_edge
        mov     across_z, r0
        mul     skip, r0
        div     divisor, r0
        add     long_edge+e_z, r0
        mov     r0, s_z(r5)
        clr     s_z+2(r5)
        call    intensity
        mov     r0, r2
        asl     r0
        mov     r0, s_i(r5)
        tst     steep
        beq     1$
        clr     s_di(r5)
        tst     r4
        beq     1$
        add     r4, r3
        call    from_long_edge
        call    intensity
        sub     r2, r0
        mov     r0, r1
        sxt     r0
        div     r4, r0
        asl     r0
        mov     r0, s_di(r5)
        sub     r4, r3
1$:     add     r3, r4
        br      started

; skip = distance of column r3's centre from the long edge, not beyond the greatest width either way. Clobbers r0.
from_long_edge:
        mov     r3, r0
        ash     #6, r0
        add     #63., r0
        sub     long_edge, r0
        cmp     r0, divisor
        ble     1$
        mov     divisor, r0
1$:     mov     r0, skip
        bpl     2$
        add     divisor, r0
        bpl     2$
        sub     r0, skip
2$:     return

; r0 = intensity at distance skip. Clobbers r1.
intensity:
        mov     across_i, r0
        mul     skip, r0
        div     divisor, r0
        add     long_edge+e_i, r0
        return

; Differences over the greatest width, from the long edge to the middle vertex, and growth a pixel. Clobbers all.
measure:
        mov     middle_vertex, r5
        mov     top_vertex, r4
        mov     low_vertex, r3
        mov     2(r5), skip
        sub     2(r4), skip
        mov     2(r3), divisor
        sub     2(r4), divisor
        .macro  beside offset           ; r0 = the middle vertex' value less the long edge's beside it
        mov     offset'(r3), r0
        sub     offset'(r4), r0
        mul     skip, r0
        div     divisor, r0
        add     offset'(r4), r0
        neg     r0
        add     offset'(r5), r0
        .endm
        beside  4
        mov     r0, across_z
        beside  6
        mov     r0, across_i
        beside  0
        mov     r0, across
        bpl     1$
        neg     across
        neg     across_z
        neg     across_i
1$:     bne     2$
        inc     across                  ; a sliver
2$:     clr     steep
        clr     quick
        mov     across, divisor
        cmp     divisor, #64.
        blt     4$                      ; no row has two pixels
        mov     across_z, r2
        cmp     divisor, #64.*short_way
        bgt     5$
        call    short_slope
        br      6$
5$:     call    slope
6$:     mov     r0, pixel_z
        mov     r1, pixel_z+2
        asl     r1
        adc     r0
        mov     r0, whole_z
        mov     across_i, r1            ; twice 64 times the difference over the width
        sxt     r0
        ashc    #7, r0
        div     divisor, r0
        bvs     3$
        mov     r0, pixel_i
        add     #steepest, r0
        cmp     r0, #2*steepest
        bhi     3$
        inc     quick
        return
3$:     inc     steep
4$:     return
