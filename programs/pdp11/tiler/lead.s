; SPDX-License-Identifier: MIT
; Deltas of a segment of an interlaced grid: its first assigned pixel may stand right of its left end, and the next ones x_step
; farther. In: r4 1 more than that lead; r2, r5 and sp as segment.s has them. Ends at draw_pixels.

lead_segment:
        dec     r4
        .if ne skip_deltas
        bne     1$
        cmp     sp, #1
        bne     1$
        jmp     single_pixel
1$:
        .endc
        mov     r4, lead
        mov     right_z, r1
        sub     left_z, r1
        divide  r2, r3
        .if ne full
        mov     r3, whole
        mov     r0, fraction
        value_after lead, left_z
        mov     r0, start_z
        mov     r1, start_z+2
        mov     whole, r0
        mov     fraction, r1
        join_slope r0, r1
        scale_slope x_step, x_shift
        mov     r0, pixel_dz
        mov     r1, pixel_dz+2
        mov     right_shade, r1
        sub     left_shade, r1
        divide  r2, r3
        mov     r3, whole
        mov     r0, fraction
        value_after lead, left_shade
        mov     r0, r4
        mov     r1, r2
        mov     whole, r0
        mov     fraction, r1
        join_slope r0, r1
        scale_slope x_step, x_shift
        mov     r0, pixel_dshade
        mov     r1, r0
        mov     start_z, r3
        mov     start_z+2, r1
        .iff
        value_after lead, left_z
        mov     r1, start_z
        scale_slope x_step, x_shift
        mov     r0, r4
        mov     right_shade, r1
        sub     left_shade, r1
        divide  r2, r3
        value_after lead, left_shade
        mov     r1, start_shade
        scale_slope x_step, x_shift
        mov     start_z, r3
        mov     start_shade, r1
        .endc
tap_pixels_lead:
        jmp     draw_pixels
