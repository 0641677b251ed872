; SPDX-License-Identifier: MIT
; The inner loop: a segment a line, until a side comes to its next vertex.

; Adds a delta to its value. r3 and r4 stand behind the two, and at them afterwards.
        .macro  add_delta
        add     -(r3), -(r4)
        .if ne full
        adc     -(r4)
        add     -(r3), (r4)
        .endc
        .endm

; A side goes on to the next line.
        .macro  add_deltas side
        mov     #side'_deltas_end, r3
        mov     #side'_end, r4
        add_side
        .endm

        .macro  add_side
        add_delta
        add_delta
        add_delta
        .endm

next_segment:
        add_deltas right
        add_side                        ; the left one's words stand before the right one's

; In: the sides' values; row. In registers: r5 the first assigned pixel's depth word, sp their number, r2 the steps from
; the left end to the right one.
tap_segment:
segment:
        mov     row, @#io_fbrow
        mov     left_x, r0
        mov     right_x, r2
        mov     r2, r1
        sub     r0, r2
        ble     narrow
        asl     r1
        mov     first_pixel+2(r1), sp   ; behind the last assigned pixel
        asl     r0
        mov     first_pixel(r0), r5
        sub     r5, sp
        beq     pixels_done
        asr     sp
        mov     lead_at(r0), r4
        beq     1$
        jmp     lead_segment
1$:
        .if ne skip_deltas
        cmp     sp, #1
        beq     single_pixel
        .endc
        mov     left_z, r3
        mov     right_z, r1
        sub     r3, r1
        divide  r2, r4
        .if ne full
        join_slope r4, r0
        mov     r4, pixel_dz
        mov     r0, pixel_dz+2
        .iff
        mov     r0, r4
        .endc
        mov     right_shade, r1
        sub     left_shade, r1
        .if ne full
        divide  r2, r4
        join_slope r4, r0
        mov     r4, pixel_dshade
        mov     left_shade, r4
        mov     #100000, r1             ; both begin with a half, so that cutting off rounds
tap_pixels:
        mov     r1, r2
        .iff
        divide  r2
tap_pixels:
        mov     left_shade, r1
        .endc

        .include "pixels.s"

tap_pixels_done:
pixels_done:
        dec     row
        dec     lines
        bgt     next_segment
        cmp     row, end_row
        beq     2$
        jmp     left_event
2$:     jmp     next_polygon

; The right end is the left one or, by rounding, left of it: one pixel, or none.
narrow: asl     r0
        mov     first_pixel(r0), r5
        cmp     r5, first_pixel+2(r0)
        beq     pixels_done
        mov     #1, sp
single_pixel:
tap_pixels_single:
        mov     left_z, r3
        cmp     r3, (r5)
        bge     pixels_done
        mov     r3, (r5)
        mov     left_shade, depth_to_image(r5)
        br      pixels_done
