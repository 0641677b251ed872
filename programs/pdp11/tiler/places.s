; SPDX-License-Identifier: MIT
; Places on the screen. In full precision x and y of vertices count in 1/32 pixel, since splitters cut polygons anywhere; a line or
; column of pixels is where the lower five bits are 0. In thesis precision they are whole.
;
; With D = a.y - b.y an edge's height and L = a.y - 32 * line how far a line is below its upper end a (both in 1/32 line),
; slope q / 2^15 = I + F / 2^15 a line, a value on the line is, with 16 bits of fraction,
;
;     (v_a << 16) + 2^15 + ((I * L) << 11) + ((F * L) >> 4)          D >= 32
;     v_a + (v_b - v_a) * L / D, cut towards zero                    D < 32: no other line crosses this edge
;
; I = 32 (v_b - v_a) / D fits a word since D >= 32; for x, itself in 1/32 pixel, I = (x_b - x_a) / D. Most edges begin on a
; line: L = 0, or in an interlace 32 times whole lines, which segment by segment take the shorter ways of edge.s.

        .if ne full
subpixels = 32.
subpixel_mask = subpixels-1
        .iff
subpixels = 1
        .endc

; From a y to twice the line at or below it, as tables want it.
        .macro  twice_line y
        .if ne full
        ash     #-5, y
        .endc
        asl     y
        .endm

; Likewise twice the line at or above it.
        .macro  twice_line_above y
        .if ne full
        add     #subpixel_mask, y
        .endc
        twice_line y
        .endm

; x in reg to the nearest pixel.
        .macro  nearest_pixel x
        .if ne full
        add     #subpixels/2, x
        ash     #-5, x
        .endc
        .endm

; Differences of z and shade are multiplied by 32 before they are divided by a height: divide's `shift`.
shift_of_at_x = 0
        .if ne full
shift_of_at_z = 5
shift_of_at_shade = 5
        .iff
shift_of_at_z = 0
shift_of_at_shade = 0
        .endc

        .if ne full

; The value at the vertex at r5, pushed before sp with a half for rounding. Clobbers r0 and r1.
        .macro  push_start at
        .if idn <at>, <at_x>
        mov     at(r5), r0
        add     #subpixels/2, r0
        clr     r1
        ashc    #-5, r0
        mov     r1, -(sp)
        mov     r0, -(sp)
        .iff
        mov     #100000, -(sp)
        mov     at(r5), -(sp)
        .endc
        .endm

; Adds r0:r1 to the value pushed last.
        .macro  add_to_pushed
        add     r1, 2(sp)
        adc     (sp)
        add     r0, (sp)
        .endm

; The value `lag` whole lines below the vertex. In: I in r3, F in r0. Clobbers r0, r1, r3.
        .macro  push_value_lines_below at
        .if idn <at>, <at_x>
        value_after lag, #0
        mov     r1, -(sp)
        mov     r0, -(sp)
        mov     at(r5), r0
        clr     r1
        ashc    #-5, r0
        add_to_pushed
        .iff
        value_after lag, at(r5)
        mov     r1, -(sp)
        mov     r0, -(sp)
        .endc
        .endm

; The value L = `lag` below the vertex. In: I in r3, F in r0. Clobbers r0, r1, r3.
        .macro  push_value_below at
        mul     lag, r0
        ashc    #-4, r0
        add     #100000, r1
        adc     r0
        mov     r1, -(sp)
        mov     r0, -(sp)
        mov     r3, r0
        mul     lag, r0
        ashc    #11., r0
        add_to_pushed
        .if idn <at>, <at_x>
        mov     at(r5), r0
        clr     r1
        ashc    #-5, r0
        add_to_pushed
        .iff
        add     at(r5), (sp)
        .endc
        .endm

; What a value has changed by L below the vertex at r5 on an edge less than a line high, to r0. In: D in r2, L in register or
; place `below`. Clobbers r1.
        .macro  short_change at, below
        mov     at(r4), r0
        sub     at(r5), r0
        mul     below, r0
        div     r2, r0
        .endm

; The value itself, pushed; a fraction is not wanted, since the next line belongs to another edge. In: the change in r0.
        .macro  push_changed at
        add     at(r5), r0
        .if idn <at>, <at_x>
        nearest_pixel r0
        .endc
        clr     -(sp)
        mov     r0, -(sp)
        .endm

; In: r2 = a.y, r3 = b.y. Out: lag = L, r2 = D. Clobbers r0, r1.
        .macro  edge_lag
        mov     row, r1
        asl     r1
        mov     line_of(r1), r1
        ash     #5, r1
        mov     r2, r0
        sub     r1, r0
        mov     r0, lag
        sub     r3, r2
        .endm

        .endc
