; SPDX-License-Identifier: MIT
; Geometry, second stage, part 2: makes a candidate (r30) a descriptor; follows light within the same procedure. Edges are exact. A parameter with the values p at the vertices has, per
; pixel, the slope 2^4 (p0 e12 + p1 e20 + p2 e01) / area along x, e the edges' A; along y their B (Eldridge 1995, figure 3-9). The sums
; are exact in 32 bits, the area's reciprocal is taken once, in 16 bits. Both are 0 where the area is less than 1/16 pixel, beyond the shift that
; `slope` has. C is such that p is right at vertex 0.
;
; Slopes are kept modulo 2^32, however steep: samples are whole pixels, and what they lose are whole multiples of 2^16 in p. C, whose vertex may lie
; between pixels, needs four bits more. Relative errors of the area's reciprocal are the same in both slopes, so they change p only by that part of its
; difference from vertex 0. The intensity's slopes have one word each, with no room for this: where one does not fit both are 0, and the intensity is
; the vertices' mean.
;
; Registers: r1 the descriptor, r3 sx0, r4 sy0, r9 r10 A and B of edge 01, r11 r12 of 12, r13 r14 of 20, r15 2^46 / (area 2^s), r16
; 2^((s - 10) mod 16), r17 1 where s < 10, else 0, r18 2^12 sx0, r19 2^12 sy0, r20 0x8000, r21 to r23 2^28 / z'.

; Edge from i to j: its A, B (written) and the descriptor's words for it, at `to`. l, h, t, u: spoilt.
        .macro  edge to, a, b, xi, yi, xj, yj, l, h, t, u
        sub     a, yj, yi
        sub     b, xi, xj
        product l, h, xj, yi
        sub_product l, h, xi, yj, t, u
        mulu    l, l, #0x1000, 16       ; 32 bits to the right by 4
        mul     t, h, #0x1000, 0
        or      l, l, t
        mul     h, h, #1, 4
        st      a, to(r1)
        st      b, to+1(r1)
        st      l, to+2(r1)
        st      h, to+3(r1)
        .endm

; over:hi:lo := the slope for edge coefficients e12, e20, e01, s31.16. words: four of memory, where the product of 48 bits waits to be read
; shifted by one word or none. t, u, v, w: spoilt.
        .macro  slope lo, hi, over, e12, e20, e01, p0, p1, p2, words, t, u, v, w
        productsu t, u, e12, p0
        productsu lo, hi, e20, p1
        add32   t, u, t, u, lo, hi
        productsu lo, hi, e01, p2
        add32   t, u, t, u, lo, hi
        product48 lo, hi, over, t, u, r15, v
        mul     v, over, #1, 15
        st      lo, words
        st      hi, words+1
        st      over, words+2
        st      v, words+3
        ld      t, words(r17)
        ld      u, words+1(r17)
        ld      v, words+2(r17)
        mulu    lo, t, r16, 16
        mulu    w, u, r16, 0
        or      lo, lo, w
        mulu    hi, u, r16, 16
        mulu    w, v, r16, 0
        or      hi, hi, w
        mulsu   over, v, r16, 16
        .endm

; mask := -1 where both upper words fit theirs, else 0. Changes T; t: spoilt.
        .macro  both_fit mask, hi1, over1, hi2, over2, t
        mul     t, hi1, #1, 15
        teq     t, over1
        mul     t, hi2, #1, 15
        teq.and t, over2
        tget    mask
        sub     mask, r0, mask
        .endm

; cl:ch := cl:ch - over:hi:lo * s / 16; s12 = 2^12 s. t, u: spoilt.
        .macro  less_slope cl, ch, lo, hi, over, s, s12, t, u
        mulsu   t, s, lo, 4
        mulsu   u, s, lo, 20
        sub32   cl, ch, cl, ch, t, u
        mul     t, hi, s12, 0
        mulsu   u, s, hi, 4
        sub32   cl, ch, cl, ch, t, u
        mul     t, over, s12, 0
        sub     ch, ch, t
        .endm

; The descriptor's six words at `to` for the unsigned values p0 ... p2; fraction: added to them, in 2^-16. Spoils r2, r5 ... r8, r27 ... r31.
        .macro  plane to, p0, p1, p2, fraction
        slope   r2, r5, r6, r11, r13, r9, p0, p1, p2, words_x, r28, r29, r30, r31
        slope   r7, r8, r27, r12, r14, r10, p0, p1, p2, words_y, r28, r29, r30, r31
        st      r2, to(r1)
        st      r5, to+1(r1)
        st      r7, to+2(r1)
        st      r8, to+3(r1)
        mov     r30, fraction
        mov     r31, p0
        less_slope r30, r31, r2, r5, r6, r3, r18, r28, r29
        less_slope r30, r31, r7, r8, r27, r4, r19, r2, r5
        st      r30, to+4(r1)
        st      r31, to+5(r1)
        .endm

; hi:over := hi:over, rounded by lo.
        .macro  round_slope lo, hi, over
        adds    lo, lo, r20
        adc     hi, hi, r0
        adc     over, over, r0
        .endm

; cl:ch := cl:ch - slope * s * 16. t, u: spoilt.
        .macro  less_short_slope cl, ch, slope, s, t, u
        mul     t, slope, s, 0
        mul     t, t, #16
        mul     u, slope, s, 12
        sub32   cl, ch, cl, ch, t, u
        .endm

; The intensity's four words, half a unit added; its values are 8.8, its slopes the upper words of s15.16. Spoils the same.
        .macro  intensity_plane to, p0, p1, p2
        slope   r2, r5, r6, r11, r13, r9, p0, p1, p2, words_x, r28, r29, r30, r31
        slope   r7, r8, r27, r12, r14, r10, p0, p1, p2, words_y, r28, r29, r30, r31
        round_slope r2, r5, r6
        round_slope r7, r8, r27
        both_fit r28, r5, r6, r8, r27, r29
        and     r5, r5, r28
        and     r8, r8, r28
        st      r5, to(r1)
        st      r8, to+1(r1)
        mulu    r29, p0, #0x5555, 16    ; p0, or the mean
        mulu    r30, p1, #0x5555, 16
        mulu    r31, p2, #0x5555, 16
        add     r29, r29, r30
        add     r29, r29, r31
        sub     r29, r29, p0
        andn    r29, r29, r28
        add     r29, r29, p0
        mul     r30, r29, #256, 0
        mulu    r31, r29, #256, 16
        add32   r30, r31, r30, r31, r20, r0
        less_short_slope r30, r31, r5, r3, r28, r29
        less_short_slope r30, r31, r8, r4, r6, r27
        st      r30, to+2(r1)
        st      r31, to+3(r1)
        .endm

; p := d times a byte (a mask) of the texture coordinates of the vertex at v in polygon r2, / 256. t: spoilt.
        .macro  texture_value p, d, v, byte, pick, t
        ld      t, <7*v>+6(r2)
        and     t, t, #byte
        mulu    p, d, t, pick
        .endm

        .macro  texture_plane to, byte, pick
        ld      r2, d_polygon(r1)
        texture_value r24, r21, 0, byte, pick, r5
        texture_value r25, r22, 1, byte, pick, r6
        texture_value r26, r23, 2, byte, pick, r7
        plane   to, r24, r25, r26, r20
        .endm

; One side of the box, at `at`, made to lie on the screen.
        .macro  keep_low at, t, u
        ld      t, at(r1)
        positive t, t, u
        st      t, at(r1)
        .endm

        .macro  keep_high at, size, t, u
        ld      t, at(r1)
        at_most t, t, size-1, u
        st      t, at(r1)
        .endm

planes:
        mov     r1, r30
        keep_low d_left, r2, r3
        keep_high d_right, screen_columns, r4, r5
        keep_low d_top, r6, r7
        keep_high d_bottom, screen_rows, r8, r9
        ld      r3, d_screen+0(r1)
        ld      r4, d_screen+1(r1)
        ld      r5, d_screen+2(r1)
        ld      r6, d_screen+3(r1)
        ld      r7, d_screen+4(r1)
        ld      r8, d_screen+5(r1)
        ld      r28, d_area(r1)
        ld      r29, d_area+1(r1)
        ld      r21, d_reciprocals(r1)
        ld      r22, d_reciprocals+1(r1)
        ld      r23, d_reciprocals+2(r1)
        edge    d_edges, r9, r10, r3, r4, r5, r6, r15, r16, r17, r18
        edge    d_edges+4, r11, r12, r5, r6, r7, r8, r19, r20, r24, r25
        edge    d_edges+8, r13, r14, r7, r8, r3, r4, r15, r16, r17, r18
        tltu    r28, #32
        teq.and r29, r0
        tget    r27
        sub     r27, r27, #1            ; 0 where the area is too small
        normalise r29, r28, r17, r26, r25, r24
        reciprocal r15, r29, r28, r26, r25
        and     r15, r15, r27
        sub     r17, r17, #10
        mov     r16, #1
        shl     r16, r16, r17
        shr     r17, r17, #15
        mul     r18, r3, #0x1000
        mul     r19, r4, #0x1000
        mov     r20, #0x8000
        ld      r24, d_lit(r1)
        ld      r25, d_lit+1(r1)
        ld      r26, d_lit+2(r1)
        intensity_plane d_intensity, r24, r25, r26
        plane   d_depth, r21, r22, r23, r0
        .if ne textured
        texture_plane d_u, 0xff00, 16
        texture_plane d_v, 0xff, 8
        .endc
        ld      r2, d_polygon(r1)
        .irp    k, <0, 1, 2>
        ld      r5, 21+k(r2)
        st      r5, d_colour+k(r1)
        .endr
        st      r0, d_passes(r1)
        add     r1, r1, #kDescriptor
        st      r1, next_slot
        setp    light
        line
