; SPDX-License-Identifier: MIT
; One sample of a polygon and the step to the next row, for rasterise.s and rasterise_region.s. The including file says by macros where pixels and steps
; are: load_pixel, store_pixel, next_row, step_edge, step_intensity; and by `drawn` what is to be done where a sample is drawn.
; deferred 1: a pixel gets the address of its polygon's descriptor in place of a colour (shade.s): depth, fraction, address.
; Registers to work with: r16, r17, r22 ... r31

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

        .macro  step hi, lo, at, p, q
        ld      p, at(polygon)
        ld      q, at+1(polygon)
        adds    lo, lo, p
        adc     hi, hi, q
        .endm

        .include "colour.s"

; T := visible: inside, within the rows, nearer than the pixel. r24: the depth's fraction, upper byte
        .macro  visible inside
        load_pixel r22, 0
        load_pixel r23, 1
        tge     e0h, r0
        tge.and e1h, r0
        tge.and e2h, r0
        .if ne early_abort
        tget    inside
        .endc
        tltu.and pixel, pixels
        .if ne deferred
        subs    r0, r23, zl
        .else
        and     r24, zl, #0xff00
        subs    r0, r23, r24            ; the red below the pixel's fraction makes no difference
        .endc
        sbc     r0, r22, zh
        tltb.and r0, r0
        .endm

        .macro  draw_colour
        ld      r27, n_red(polygon)
        ld      r28, n_green(polygon)
        ld      r29, n_blue(polygon)
        .if ne textured
        tget    r31
        ld      r30, n_texture(polygon)
        tne.and r30, r0
        slf
        texture zh, zl, uh, ul, vh, vl
        wake
        tne     r31, r0
        .endc
        intensity ih
        slf
        blend
        drawn
        store_pixel zh, 0
        store_pixel r24, 1
        store_pixel r28, 2
        wake
        .endm

        .macro  draw_address
        slf
        drawn
        store_pixel zh, 0
        store_pixel zl, 1
        store_pixel polygon, 2
        wake
        .endm

        .macro  sample before, inside
        visible inside
        .if ne deferred
        draw_address
        .else
        draw_colour
        .endc
        step_edge e0h, e0l, n_edges, r22, r23
        step_edge e1h, e1l, n_edges+4, r26, r30
        step_edge e2h, e2l, n_edges+8, r22, r23
        step    zh, zl, n_depth, r26, r30
        .if eq deferred
        step_intensity ih, il, r22, r23
        .if ne textured
        step    uh, ul, n_u, r26, r30
        step    vh, vl, n_v, r22, r23
        .endc
        .endc
        next_row
        .if ne early_abort
        tge     inside, before
        tget    r26
        mul     pixels, pixels, r26
        .endc
        .endm
