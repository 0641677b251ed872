; SPDX-License-Identifier: MIT
; Deltas of a segment of an interlaced grid: its first assigned pixel may stand right of its left end, and the next ones x_step
; farther. In: r4 1 more than that lead; r2, r5 and sp as segment.s has them. Ends at draw_pixels.

; In: what `divide` left, I in r4. Out: full: the slope from step to step in r0:r1, r4 is free; thesis: in r0. Clobbers r1, r3.
        .macro  lead_slope
        .if ne full
        mov     r0, r1
        mov     r4, r0
        join_slope r0, r1
        .endc
        scale_slope x_step, x_shift
        .endm

; In: what `divide r2, r4` left. Out: full: the value at the first assigned pixel in r2:r3; thesis: in r1. r0 and r4 stay.
        .macro  lead_value from, ?level
        .if ne full
        mov     r0, r2
        mul     lead, r2
        asl     r3
        rol     r2
        mov     r4, r1
        beq     level                   ; less than a step a pixel, as shade and the ground's depth often have
        mul     lead, r1
        add     r1, r2
level:  add     #100000, r3             ; a half, for rounding
        adc     r2
        add     from, r2
        .iff
        mov     r0, r1
        mul     lead, r1
        add     from, r1
        .endc
        .endm

lead_segment:
        dec     r4
        bne     lead_some

; The left end is an assigned pixel.
        .if ne skip_deltas
        cmp     sp, #1
        bne     lead_slopes
        jmp     single_pixel
lead_slopes:
        .endc
        mov     right_z, r1
        sub     left_z, r1
        divide  r2, r4
        lead_slope
        mov     r0, pixel_dz
        .if ne full
        mov     r1, pixel_dz+2
        .endc
        mov     right_shade, r1
        sub     left_shade, r1
        divide  r2, r4
        lead_slope
        .if ne full
        mov     r0, pixel_dshade
        mov     r1, r0
        mov     left_shade, r4
        mov     #100000, r1
        mov     r1, r2
        .iff
        mov     left_shade, r1
        mov     pixel_dz, r4
        .endc
        mov     left_z, r3
tap_pixels_lead_none:
        jmp     draw_pixels

; It is not.
lead_some:
        mov     r4, lead
        mov     r2, steps
        mov     right_z, r1
        sub     left_z, r1
        divide  steps, r4
        lead_value left_z
        .if ne full
        mov     r2, start_z
        mov     r3, start_z+2
        .iff
        mov     r1, start_z
        .endc
        lead_slope
        mov     r0, pixel_dz
        .if ne full
        mov     r1, pixel_dz+2
        .endc
        mov     right_shade, r1
        sub     left_shade, r1
        divide  steps, r4
        lead_value left_shade
        .if ne full
        mov     r0, r1
        mov     r4, r0
        mov     r2, r4
        mov     r3, r2
        join_slope r0, r1
        scale_slope x_step, x_shift
        mov     r0, pixel_dshade
        mov     r1, r0
        mov     start_z, r3
        mov     start_z+2, r1
        .iff
        mov     r1, start_shade
        lead_slope
        mov     start_shade, r1
        mov     start_z, r3
        mov     pixel_dz, r4
        .endc
tap_pixels_lead:
        jmp     draw_pixels
