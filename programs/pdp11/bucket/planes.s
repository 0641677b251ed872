; SPDX-License-Identifier: MIT
; Planes: the values at the first pixel of the triangle that is drawn in the tile, and what is added for the next column and the next
; line (machine/host/triangle_planes.hpp, whose names these are).

; In: r0 the pixel's column; row. Clobbers all registers.
planes:
tap_vertex_planes:
        mov     top, r5
        mov     middle, r4
        mov     bottom, sp
        mov     r0, column
        add     tile_left, r0
        ash     #4, r0
        sub     at_x(r5), r0
        mov     r0, from_x
        mov     row, r0
        add     tile_top, r0
        ash     #4, r0
        sub     (r5), r0
        mov     r0, from_y

; A, in r0:r1
        mov     at_x(r4), r0
        sub     at_x(r5), r0
        mov     (r4), r1
        sub     (r5), r1
        mov     (sp), r2
        sub     (r5), r2
        mov     r2, r3
        tst     middle_is_left
        beq     1$
        neg     r1
        neg     r2
1$:     mov     r1, middle_y
        mov     r2, long_y
        mov     r3, height_15
        mul     r2, r0
        mov     at_x(sp), r2
        sub     at_x(r5), r2
        mov     r2, long_x
        mul     middle_y, r2
        sub     r3, r1
        sbc     r0
        sub     r2, r0

; A' and a, in r2. A has 30 bits at most; bit 15 of r0 is to be its first one.
        mov     #17., r2
        tst     r0
        bne     2$
        ashc    #15., r0
        sub     #15., r2
2$:     bit     #177600, r0
        bne     3$
        ashc    #8., r0
        sub     #8., r2
3$:     dec     r2
        asl     r1
        rol     r0
        bpl     3$
        clc
        ror     r0
        mov     r0, area_15

; D' and k, in r3
        mov     height_15, r0
        mov     #-1, r3
        bit     #177600, r0
        bne     4$
        ash     #7, r0
        add     #7, r3
4$:     inc     r3
        asl     r0
        bpl     4$
        clc
        ror     r0
        mov     r0, height_15

; p in r2, and what follows from it
        mov     r3, r0
        dec     r0
        add     r0, r2
        bgt     5$
        mov     #1, r2                  ; a sliver
        mov     #-32., r0               ; by which any N becomes 0 or -1
5$:     mov     r0, shift_n
        mov     r2, precision
        mov     #20., r0
        sub     r2, r0
        mov     r0, shift_x
        sub     #4, r0
        mov     r0, shift_x_16
        add     #7, r3
        sub     r2, r3
        clr     shift_g
        tst     r3
        bpl     6$
        mov     r3, shift_g
        clr     r3
6$:     mov     r3, shift_y
        sub     #4, r3
        mov     r3, shift_y_low
        add     #15., r3
        mov     r3, shift_y_high

; A quarter of a difference of unsigned words, from the difference and the borrow.
        .macro  quarter register
        ror     register
        asr     register
        .endm

; In: T, M, B in r5, r4, sp. Clobbers r0 to r3.
        .macro  plane value, at, is_place, ?sloped, ?level, ?base
        mov     at(r4), r0              ; e
        sub     at(r5), r0
        bne     sloped
        mov     at(sp), r2
        cmp     r2, at(r5)
        bne     level
        clr     value+to_m              ; the same all over
        clr     value+to_dx
        clr     value+to_dx+2
        clr     value+to_dy
        clr     value+to_dy+2
        clr     r1
        br      base
sloped:
        .if ne is_place
        quarter r0
        .endc
level:
        mul     long_y, r0
        mov     at(sp), r2              ; d
        sub     at(r5), r2
        .if ne is_place
        quarter r2
        .endc
        mov     r2, to_bottom
        mul     middle_y, r2
        sub     r3, r1
        sbc     r0
        sub     r2, r0                  ; N
        ashc    shift_n, r0
        div     area_15, r0             ; m
        mov     r0, value+to_m
        mov     r0, r2
        mul     long_x, r2
        mov     r0, r1
        sxt     r0
        ashc    shift_x, r0
        mov     r0, value+to_dx
        mov     r1, value+to_dx+2
        mov     to_bottom, r1
        sxt     r0
        ashc    precision, r0
        sub     r3, r1
        sbc     r0
        sub     r2, r0                  ; P
        ashc    #-2, r0
        div     height_15, r0           ; w
        mov     r1, r2
        clr     r3
        asr     r2
        ror     r3
        div     height_15, r2
        clr     r1
        asr     r0
        ror     r1
        add     r2, r1
        adc     r0
        tst     r2
        sxt     r2
        add     r2, r0
        ashc    shift_g, r0             ; g
        mov     r0, r2
        mov     r1, r3
        ashc    shift_y, r2
        mov     r2, value+to_dy
        mov     r3, value+to_dy+2
        asl     r1                      ; g times from_y, in two parts
        rol     r0
        clc
        ror     r1
        mov     r1, g_low
        mul     from_y, r0
        ashc    shift_y_high, r0
        mov     g_low, r2
        mul     from_y, r2
        ashc    shift_y_low, r2
        add     r3, r1
        adc     r0
        add     r2, r0
        mov     value+to_m, r2
        mul     from_x, r2
        ashc    shift_x_16, r2
        add     r3, r1
        adc     r0
        add     r2, r0
base:
        add     #100000, r1
        adc     r0
        mov     at(r5), r2
        .if ne is_place
        clc
        quarter r2
        .endc
        add     r2, r0
        mov     r1, value+2
        .endm

        plane   depth, at_depth, 0
        sub     #40000, r0
        mov     r0, depth
        plane   shade, at_shade, 0
        add     #100, r0
        mov     r0, shade
        .if ne textured
        plane   u, at_u, 1
        mov     r0, u
        plane   v, at_v, 1
        mov     r0, v
        .endc

        mov     left_x, r0
        bpl     7$
        clr     r0
7$:     jmp     span
