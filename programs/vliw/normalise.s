; SPDX-License-Identifier: MIT
; Linear equations normalised to the lane's column (Eldridge 1995, 7.5.1): of every received descriptor, in place, for the rasteriser, which
; begins at row d_top: memory.s, the words n_*. C' = C + A column + B top; what A was becomes the upper word of a step that has but one.
; Registers: r1 descriptor, r2 column, r3 row d_top, r4 first word behind the received ones, r5 ... r31 arithmetic.
; Memory: normal_next. Counter: c4. Lanes that have no more descriptors sleep.

normal_next = other_scratch+6       ; next descriptor to be normalised

        .if ne textured
kNormalised = 8                     ; on a scanline
        .else
kNormalised = 11
        .endc

        .include "descriptor.s"

        .macro  normalise_edge at, a, b, lo, hi, p, q
        edge_value r1, at, r2, r3, hi, lo, a, b, p, q
        asr     a, b, #15
        st      b, at(r1)
        st      a, at+1(r1)
        st      lo, at+2(r1)
        st      hi, at+3(r1)
        .endm

; The value of a parameter of two-word coefficients; its step is where it was already.
        .macro  normalise_long at, bias, hi, lo, ah, al, bh, bl, p, q
        long_value r1, at, r2, r3, bias, hi, lo, ah, al, bh, bl, p, q
        st      lo, at+4(r1)
        st      hi, at+5(r1)
        .endm

; Intensity comes with 8 bits of fraction in A and B.
        .macro  normalise_intensity
        intensity_value r1, r2, r3, r13, r15, r5, r6, r8, r7, r9, r10
        shl     r16, r6, #14
        asr     r17, r6, #2
        st      r16, n_intensity(r1)
        st      r17, n_intensity+1(r1)
        st      r15, n_intensity+2(r1)
        st      r13, n_intensity+3(r1)
        .endm

; Rows to places of the frame buffer
        .macro  normalise_box
        ld      r18, d_bottom(r1)
        ld      r19, drawing
        mul     r22, r3, #kPixel
        add     r22, r22, r19
        mul     r23, r18, #kPixel
        add     r23, r23, r19
        add     r23, r23, #kPixel
        st      r22, n_begin(r1)
        st      r23, n_end(r1)
        normalise_colours r1, r20, r21, r24, r25, r26, r27
        .endm

normalise:
        wake
        phase   3
        ld      r1, received_at
        st      r1, normal_next
        setp    normalise_some
        line

normalise_some:
        wake
        ld      r1, normal_next
        ld      r4, received_end
        ld      r2, column
        setc    c4, kNormalised
        tltu    r1, r4
normalise_loop:
        slf
        ld      r3, d_top(r1)
        normalise_edge d_edges, r5, r6, r7, r8, r9, r10
        normalise_edge d_edges+4, r11, r12, r13, r14, r15, r16
        normalise_edge d_edges+8, r17, r18, r19, r20, r21, r22
        normalise_long d_depth, 0, r23, r24, r25, r26, r27, r28, r29, r30
        .if ne textured
        normalise_long d_u, kUBias, r5, r6, r7, r8, r9, r10, r11, r12
        normalise_long d_v, kUBias, r13, r14, r15, r16, r17, r18, r19, r20
        .endc
        normalise_intensity
        normalise_box
        add     r1, r1, #kDescriptor
        tltu    r1, r4
        bnor    normalise_done
        dec     c4, normalise_loop
        jump    normalise_save
normalise_done:
        setp    rasterise
normalise_save:
        wake
        st      r1, normal_next
        line
