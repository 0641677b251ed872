; SPDX-License-Identifier: MIT
; The span of a row of the triangle being drawn: depth and intensity at its first pixel, and what they grow by a pixel.
; Intensities stay within those of the vertices, so that they never wrap: where they are steep, the growth is taken
; from the span's own two ends.

steepest = 4096.                ; 8.8 a pixel: with less, a shift by 1/64 pixel stays within the rounding

; The span from column r3 to r4 of the current row. Clobbers all.
make_span:
        call    get_block
        mov     #kind_span, (r5)
        mov     #-1, s_path(r5)
        movb    row, s_y(r5)
        movb    r3, s_first(r5)
        movb    r4, s_last(r5)
        mov     #s_size, b_length(r5)
        mov     across, divisor
        sub     r3, r4                  ; pixels behind the first
        call    from_long_edge
        mov     across_z, r0
        mul     skip, r0
        div     divisor, r0
        add     long_edge+e_z, r0
        mov     r0, s_z(r5)
        clr     s_z+2(r5)
        mov     pixel_z, s_dz(r5)
        mov     pixel_z+2, s_dz+2(r5)
        call    intensity
        mov     r0, r2
        asl     r0
        add     #200, r0                ; rounds when the low byte is cut off
        mov     r0, s_i(r5)
        mov     pixel_i, s_di(r5)
        tst     steep
        beq     1$
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
1$:     mov     #1, @#io_credit
        jmp     span_here

; skip = distance of column r3's centre from the long edge, not beyond the greatest width either way. Clobbers r0.
from_long_edge:
        mov     r3, r0
        ash     #6, r0
        add     #32., r0
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
        mov     across, divisor
        cmp     divisor, #64.
        blt     4$                      ; no row has two pixels
        mov     across_z, r2
        call    slope
        mov     r2, pixel_z
        mov     r0, pixel_z+2
        mov     across_i, r1            ; twice 64 times the difference over the width
        sxt     r0
        ashc    #7, r0
        div     divisor, r0
        bvs     3$
        mov     r0, pixel_i
        add     #steepest, r0
        cmp     r0, #2*steepest
        blos    4$
3$:     inc     steep
4$:     return
