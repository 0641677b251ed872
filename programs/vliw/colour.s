; SPDX-License-Identifier: MIT
; A pixel's colour: intensity times the polygon's or the texture's colour. For sample.s and shade.s.

; r25 := 64 times the intensity plus half a level, within 0 ... 255.5. ih: 64 times (the intensity less 255). Changes r26.
        .macro  intensity ih
        mul     r26, ih, #1, 15
        and     r25, ih, r26
        add     r25, r25, #64*255+32
        mul     r26, r25, #1, 15
        andn    r25, r25, r26
        .endm

; A pixel's words 1 and 2, r24 and r28, from r27, r28, r29: red, green, blue, 0 ... 65535; r25: intensity; r24: the depth's fraction, upper byte.
        .macro  blend
        mulu    r27, r27, r25, 22
        mulu    r28, r28, r25, 14
        mulu    r29, r29, r25, 22
        and     r28, r28, #0xff00
        or      r24, r24, r27
        or      r28, r28, r29
        .endm

        .if ne textured
        .include "texture.s"
        .endc
