; SPDX-License-Identifier: MIT
; Perspective-correct bilinear texture (Eldridge 1995, 7.5.2): u = (u / z) / (1 / z) by the table of reciprocals, then the mean of the four texels
; around it, weighted. The texture: memory.s.
; In: depth, u, v of the rasteriser's kind. Out: r27, r28, r29: red, green, blue, 0 ... 65535. Changes r16, r17, r22, r23, r25, r26, r30.

; The texel's bits of the three masks, 16 bits each, times weight. The first texel sets the sums, the others add to them.
        .macro  weigh_first weight
        lds     r26, 0, (r25)
        and     r27, r26, #0xf800
        mulu    r27, r27, weight, 15
        and     r28, r26, #0x07e0
        mulu    r28, r28, weight, 10
        and     r29, r26, #0x001f
        mulu    r29, r29, weight, 4
        .endm

        .macro  weigh offset, weight
        lds     r26, 0, offset(r25)
        and     r30, r26, #0xf800
        mulu    r30, r30, weight, 15
        add     r27, r27, r30
        and     r30, r26, #0x07e0
        mulu    r30, r30, weight, 10
        add     r28, r28, r30
        and     r30, r26, #0x001f
        mulu    r30, r30, weight, 4
        add     r29, r29, r30
        .endm

; c (8.8) := that of (hi:lo, biased) times r22 / 2^13, with r23 the bias times that
        .macro  coordinate c, hi, lo, work
        mulu    c, hi, r22, 13
        mulu    work, lo, r22, 29
        add     c, c, work
        sub     c, c, r23
        .endm

        .macro  texture zh, zl, uh, ul, vh, vl
        mulu    r22, zh, #0x8000, 16    ; 1/z: the table's for half the depth, to the first order corrected by its fraction f: q - f q^2 / 2^28
        ld      r22, reciprocals(r22)
        mulu    r23, zl, #0x8000, 16
        mulu    r25, zh, #0x8000
        or      r23, r23, r25
        mulu    r25, r22, r22, 16
        mulu    r25, r25, r23, 28
        sub     r22, r22, r25           ; 2^29 / depth
        mulu    r23, r22, #kUBias, 13
        coordinate r25, uh, ul, r27
        coordinate r26, vh, vl, r28
        mulu    r16, r25, #64           ; fractions of a texel, 0.15
        and     r16, r16, #0x7fc0
        mulu    r17, r26, #64
        and     r17, r17, #0x7fc0
        mulu    r25, r25, #1, 9         ; the texel's place
        mulu    r26, r26, #1, 1
        and     r26, r26, #0x7f00
        or      r25, r25, r26
        mulu    r23, r16, r17, 15       ; the four weights, together 0x8000
        sub     r22, r16, r23
        sub     r30, r23, r16
        sub     r30, r30, r17
        sub     r17, r17, r23
        add     r16, r30, #0x8000
        weigh_first r16
        weigh   1, r22
        weigh   256, r17
        weigh   257, r23
        mulu    r27, r27, #33825, 15    ; 31 and 63 become 65535
        mulu    r28, r28, #33288, 15
        mulu    r29, r29, #33825, 15
        .endm
