; SPDX-License-Identifier: MIT
; Deferred shading and texturing (Eldridge 1995, 6.5): a pixel's colour from what the rasteriser has left in it: depth, its fraction, the descriptor's
; address. The descriptor still has the parameters as they came (normalise_region.s), so that they are taken at the pixel's place on the
; screen: the same words as stepping from row to row gives. No lane sleeps: the scheduler puts it into the shifts' bundles.

        .if ne textured
kShading    = 125                       ; cycles, when nothing else is done
        .else
kShading    = 50
        .endc

; Where the texture is 0 the polygon's colour, a word of the descriptor, in place of that in `colour`. flag: 1 if textured. t, u: to work with.
        .macro  choose polygon, colour, word, flag, t, u
        ld      t, word(polygon)
        sub     u, colour, t
        mul     u, u, flag
        add     colour, t, u
        .endm

; The pixel at address `at`: depth:fraction in zh:zl, the descriptor's address in `polygon`. Makes of the last two the words 1 and 2 of memory.s.
; Changes r14 ... r31.
        .macro  shade zh, zl, polygon, at
        place   r15, r14, at, r16, r17
        intensity_value polygon, r15, r14, r31, r28, r22, r23, r24, r25, r26, r27
        .if ne textured
        long_value polygon, d_u, r15, r14, kUBias, r18, r19, r22, r23, r24, r25, r26, r27
        long_value polygon, d_v, r15, r14, kUBias, r20, r21, r22, r23, r24, r25, r28, r29
        texture zh, zl, r18, r19, r20, r21
        ld      r22, n_texture(polygon)
        tne     r22, r0
        tget    r22
        choose  polygon, r27, n_red, r22, r23, r24
        choose  polygon, r28, n_green, r22, r25, r26
        choose  polygon, r29, n_blue, r22, r16, r17
        .else
        ld      r27, n_red(polygon)
        ld      r28, n_green(polygon)
        ld      r29, n_blue(polygon)
        .endc
        intensity r31
        and     r24, zl, #0xff00
        blend
        mov     zl, r24
        mov     polygon, r28
        .endm
