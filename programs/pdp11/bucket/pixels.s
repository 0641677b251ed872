; SPDX-License-Identifier: MIT
; The pixels of a line.
; In: r5 the first pixel's depth word, sp > 0 the number of pixels; the values there.

        .ifeq   textured

; r3 and r1 the depth, the high word and 16 bits of fraction; r4 and r2 the shade likewise; r0 what is added to that fraction.
; A pixel that is drawn costs 23 cycles and a hidden one 17.
        mov     depth, r3
        mov     depth+2, r1
        mov     shade, r4
        mov     shade+2, r2
        mov     shade_dx+2, r0
tap_pixels:
next_pixel:
        cmp     r3, (r5)+
        bge     hidden
        mov     r3, -2(r5)
        mov     r4, depth_to_image-2(r5)
hidden: add     depth_dx+2, r1
        adc     r3
        add     depth_dx, r3
        add     r0, r2
        adc     r4
        add     shade_dx, r4
        sob     sp, next_pixel
        jmp     pixels_done

        .iff

; r3 and r2 the depth, r4 the high word of u, sp that of v; the rest in memory.
        mov     depth, r3
        mov     depth+2, r2
        mov     u, r4
        mov     u+2, run_u_low
        mov     v+2, run_v_low
        mov     shade, run_shade
        mov     shade+2, run_shade+2
tap_pixels:
        asl     sp
        add     r5, sp
        mov     sp, run_end
        mov     v, sp
next_pixel:
        cmp     r3, (r5)+
        bge     hidden
        mov     r3, -2(r5)
        mov     sp, r0
        clrb    r0                      ; the texel's row, times its size
        mov     r4, r1
        swab    r1
        asl     r1
        bisb    r1, r0                  ; twice the column
        mov     texture(r0), r0
        mul     run_shade, r0
        asl     r0
        mov     r0, depth_to_image-2(r5)
hidden: add     depth_dx+2, r2
        adc     r3
        add     depth_dx, r3
        add     u_dx+2, run_u_low
        adc     r4
        add     u_dx, r4
        add     v_dx+2, run_v_low
        adc     sp
        add     v_dx, sp
        add     shade_dx+2, run_shade+2
        adc     run_shade
        add     shade_dx, run_shade
        cmp     r5, run_end
        blo     next_pixel
        jmp     pixels_done

        .endc
