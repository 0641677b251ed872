; SPDX-License-Identifier: MIT
; The pixels of a segment.
; In: r5 the first pixel's depth word, sp > 0 the number of pixels.
;   full:   r3 and r1 its depth, the high word and 16 bits of fraction; r4 and r2 its shade likewise; pixel_dz, pixel_dz+2,
;           pixel_dshade and r0 what to add to each for the next pixel.
;   thesis: r3 and r1 its depth and shade; r4 and r0 what to add.
; A pixel that is drawn costs 23 cycles and a hidden one 17, in a long run of full precision (long_run.s) 20.5 and 14.5; in
; thesis precision 13 and 7.

        .macro  put_pixel z, shade, ?hidden
        cmp     z, (r5)+
        bge     hidden
        mov     z, -2(r5)
        mov     shade, depth_to_image-2(r5)
hidden:
        .endm

; Full precision; dz is the place of the fraction that is added to the depth's.
        .macro  next_pixel dz
        add     dz, r1
        adc     r3
        add     pixel_dz, r3
        add     r0, r2
        adc     r4
        add     pixel_dshade, r4
        .endm

draw_pixels:
        .if ne full
        cmp     sp, #long_run
        bhis    begin_long_run
short_run:
        put_pixel r3, r4
        next_pixel pixel_dz+2
        sob     sp, short_run

        .iff

short_run:
        put_pixel r3, r1
        add     r4, r3
        add     r0, r1
        sob     sp, short_run
        .endc
