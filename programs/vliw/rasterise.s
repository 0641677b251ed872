; SPDX-License-Identifier: MIT
; Rasterising by half-planes (Eldridge 1995, 3.2.3, 7.5.2, 7.5.3): a lane walks down the rows of its column through one received descriptor after
; the other, in the form that normalise.s has given them. A sample is drawn where all three edges are >= 0 and its depth is greater than
; the pixel's, with the polygon's (or texture's) colour times the intensity.
;
; Lanes are decoupled: after every `samples` rows those that are done take their next descriptor; decoupled 0: they wait for each other.
; early_abort 1: a row outside behind one inside ends the descriptor, since triangles are convex.
; Line-locked: kRounds times `samples` rows on a scanline. Memory: raster_* keeps the registers below from scanline to scanline. Counter: c5.
; Registers to work with: r16, r17, r22 ... r31

raster_next = other_scratch+7       ; next descriptor to be taken
raster_at   = other_scratch+8       ; 19 words

        .if ne samples&1
        .error  samples must be even
        .endc
        .if ne textured
kRounds     = 2
        .else
kRounds     = 3
        .endc

; A lane's place in its descriptor: the equations' values at the present row, upper and lower words.
e0h     = r1
e0l     = r2
e1h     = r3
e1l     = r4
e2h     = r5
e2l     = r6
zh      = r7
zl      = r8
ih      = r9
il      = r10
uh      = r11
ul      = r12
vh      = r13
vl      = r14
pixel   = r15           ; address of the present row's
pixels  = r18           ; first address below the descriptor; 0: done
polygon = r19           ; the descriptor
inside0 = r20           ; whether the latest sample was inside; even and odd samples take turns
inside1 = r21

        .macro  raster_words op
at = raster_at
        .irp    reg, <e0h, e0l, e1h, e1l, e2h, e2l, zh, zl, ih, il, pixel, pixels, polygon, inside0>
        op      reg, at
at = at+1
        .endr
        .if ne textured
        .irp    reg, <uh, ul, vh, vl>
        op      reg, at
at = at+1
        .endr
        .endc
        .endm

        .macro  load_value hi, lo, at
        ld      lo, at+2(polygon)
        ld      hi, at+3(polygon)
        .endm

; Lanes that are done take their next descriptor, if they have one.
        .macro  advance
        tgeu    pixel, pixels
        slf
        mov     pixels, r0
        ld      r16, raster_next
        ld      r17, received_end
        tltu    r16, r17
        slf
        mov     polygon, r16
        add     r16, r16, #kDescriptor
        st      r16, raster_next
        load_value e0h, e0l, n_edges
        load_value e1h, e1l, n_edges+4
        load_value e2h, e2l, n_edges+8
        load_value zh, zl, n_depth
        load_value ih, il, n_intensity
        .if ne textured
        load_value uh, ul, n_u
        load_value vh, vl, n_v
        .endc
        ld      pixel, n_begin(polygon)
        ld      pixels, n_end(polygon)
        mov     inside0, r0
        wake
        .endm

        .macro  step hi, lo, at, p, q
        ld      p, at(polygon)
        ld      q, at+1(polygon)
        adds    lo, lo, p
        adc     hi, hi, q
        .endm

; r25 := 64 times the intensity plus half a level, within 0 ... 255.5
        .macro  intensity
        mul     r26, ih, #1, 15
        and     r25, ih, r26
        add     r25, r25, #64*255+32
        mul     r26, r25, #1, 15
        andn    r25, r25, r26
        .endm

; T := visible: inside, within the rows, nearer than the pixel. r24: the depth's fraction, upper byte
        .macro  visible inside
        ld      r22, 0(pixel)
        ld      r23, 1(pixel)
        and     r24, zl, #0xff00
        tge     e0h, r0
        tge.and e1h, r0
        tge.and e2h, r0
        .if ne early_abort
        tget    inside
        .endc
        tltu.and pixel, pixels
        subs    r0, r23, r24            ; the red below the pixel's fraction makes no difference
        sbc     r0, r22, zh
        tltb.and r0, r0
        .endm

; r27, r28, r29: the colour, times 257
        .macro  draw
        mulu    r27, r27, r25, 22
        mulu    r28, r28, r25, 14
        mulu    r29, r29, r25, 22
        and     r28, r28, #0xff00
        or      r24, r24, r27
        or      r28, r28, r29
        st      zh, 0(pixel)
        st      r24, 1(pixel)
        st      r28, 2(pixel)
        .endm

        .macro  sample before, inside
        visible inside
        ld      r27, n_red(polygon)
        ld      r28, n_green(polygon)
        ld      r29, n_blue(polygon)
        .if ne textured
        tget    r31
        ld      r30, n_texture(polygon)
        tne.and r30, r0
        slf
        texture
        wake
        tne     r31, r0
        .endc
        intensity
        slf
        draw
        wake
        step    e0h, e0l, n_edges, r22, r23
        step    e1h, e1l, n_edges+4, r26, r30
        step    e2h, e2l, n_edges+8, r22, r23
        step    zh, zl, n_depth, r26, r30
        step    ih, il, n_intensity, r22, r23
        .if ne textured
        step    uh, ul, n_u, r26, r30
        step    vh, vl, n_v, r22, r23
        .endc
        add     pixel, pixel, #kPixel
        .if ne early_abort
        tge     inside, before
        tget    r26
        mul     pixels, pixels, r26
        .endc
        .endm

        .if ne textured
        .include "texture.s"
        .endc

rasterise:
        wake
        phase   4
        ld      r1, received_at
        st      r1, raster_next
        mov     polygon, r1             ; lanes that have nothing must read somewhere
        mov     pixels, r0
        raster_words st
        setp    rasterise_some
        line

rasterise_some:
        wake
        raster_words ld
        .if ne line_locked
        setc    c5, kRounds
        .endc
rasterise_round:
        .if eq decoupled
        tltu    pixel, pixels
        bor     rasterise_rows
        .endc
        advance
rasterise_rows:
        .rept   samples/2
        sample  inside0, inside1
        sample  inside1, inside0
        .endr
        .if ne line_locked
        dec     c5, rasterise_round
        .endc
        ld      r16, raster_next
        ld      r17, received_end
        tltu    pixel, pixels
        tltu.or r16, r17
        .if ne line_locked
        bor     rasterise_save
        .else
        bor     rasterise_round
        .endc
        setp    finish
rasterise_save:
        raster_words st
        line
