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

; hi:lo += a by, with a a word; p and q to work with.
        .macro  add_product hi, lo, a, by, p, q
        mul     p, a, by
        mul     q, a, by, 16
        adds    lo, lo, p
        adc     hi, hi, q
        .endm

; hi:lo += ah:al by, with 0 <= by
        .macro  add_long_product hi, lo, ah, al, by, p, q
        mul     p, al, by
        mulu    q, al, by, 16
        mul     ah, ah, by
        add     q, q, ah
        adds    lo, lo, p
        adc     hi, hi, q
        .endm

        .macro  normalise_edge at, a, b, lo, hi, p, q
        ld      a, at(r1)
        ld      b, at+1(r1)
        ld      lo, at+2(r1)
        ld      hi, at+3(r1)
        add_product hi, lo, a, r2, p, q
        add_product hi, lo, b, r3, p, q
        asr     a, b, #15
        st      b, at(r1)
        st      a, at+1(r1)
        st      lo, at+2(r1)
        st      hi, at+3(r1)
        .endm

; Leaves the step in bh:bl, the value in hi:lo.
        .macro  normalise_long at, ah, al, bh, bl, hi, lo, p, q, r
        ld      al, at(r1)
        ld      ah, at+1(r1)
        ld      bl, at+2(r1)
        ld      bh, at+3(r1)
        ld      lo, at+4(r1)
        ld      hi, at+5(r1)
        add_long_product hi, lo, ah, al, r2, p, q
        mov     r, bh
        add_long_product hi, lo, r, bl, r3, p, q
        .endm

; The value of a parameter of two-word coefficients; its step is where it was already.
        .macro  normalise_long at, bias, hi, lo, ah, al, bh, bl, p, q
        ld      al, at(r1)
        ld      ah, at+1(r1)
        ld      bl, at+2(r1)
        ld      bh, at+3(r1)
        ld      lo, at+4(r1)
        ld      hi, at+5(r1)
        add_long_product hi, lo, ah, al, r2, p, q
        add_long_product hi, lo, bh, bl, r3, p, q
        .if ne bias
        adds    lo, lo, #0x8000         ; the bias less half a unit, which is in the descriptor
        adc     hi, hi, #bias-1
        .endc
        st      lo, at+4(r1)
        st      hi, at+5(r1)
        .endm

; Intensity comes with 8 bits of fraction in A and B; what the rasteriser wants is 64 times it, less 255.
        .macro  normalise_intensity
        ld      r5, d_intensity(r1)
        ld      r6, d_intensity+1(r1)
        ld      r7, d_intensity+2(r1)
        ld      r8, d_intensity+3(r1)
        mul     r9, r5, r2
        mul     r10, r5, r2, 8
        shl     r9, r9, #8
        adds    r7, r7, r9
        adc     r8, r8, r10
        mul     r11, r6, r3
        mul     r12, r6, r3, 8
        shl     r11, r11, #8
        adds    r7, r7, r11
        adc     r8, r8, r12
        subs    r7, r7, #0x8000         ; the half unit
        sbc     r8, r8, #255
        shl     r13, r8, #6
        shr     r14, r7, #10
        or      r13, r13, r14
        shl     r15, r7, #6
        shl     r16, r6, #14
        asr     r17, r6, #2
        st      r16, n_intensity(r1)
        st      r17, n_intensity+1(r1)
        st      r15, n_intensity+2(r1)
        st      r13, n_intensity+3(r1)
        .endm

; Rows to places of the frame buffer, colours to 16 bits, texture to one word
        .macro  normalise_box
        ld      r18, d_bottom(r1)
        ld      r19, drawing
        ld      r20, d_colour(r1)
        ld      r21, d_colour+1(r1)
        mul     r22, r3, #kPixel
        add     r22, r22, r19
        mul     r23, r18, #kPixel
        add     r23, r23, r19
        add     r23, r23, #kPixel
        shr     r24, r20, #8
        mulu    r24, r24, #257
        and     r25, r20, #0xff
        mulu    r25, r25, #257
        shr     r26, r21, #8
        mulu    r26, r26, #257
        st      r22, n_begin(r1)
        st      r23, n_end(r1)
        st      r24, n_red(r1)
        st      r25, n_green(r1)
        st      r26, n_blue(r1)
        .if ne textured
        ld      r27, d_colour+2(r1)
        and     r28, r21, #0xff
        or      r28, r28, r27
        st      r28, n_texture(r1)
        .endc
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
