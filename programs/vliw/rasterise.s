; SPDX-License-Identifier: MIT
; Rasterising by half-planes (Eldridge 1995, 3.2.3, 7.5.2, 7.5.3): a lane walks down the rows of its column through one received descriptor after
; the other, in the form that normalise.s has given them. A sample is drawn where all three edges are >= 0 and its depth is greater than
; the pixel's, with the polygon's (or texture's) colour times the intensity.
;
; Lanes are decoupled: after every `samples` rows those that are done take their next descriptor; decoupled 0: they wait for each other.
; early_abort 1: a row outside behind one inside ends the descriptor, since triangles are convex.
; Line-locked: kRounds times `samples` rows on a scanline. Memory: raster_* keeps the registers below from scanline to scanline. Counter: c5.

raster_next = other_scratch+7       ; next descriptor to be taken
raster_at   = other_scratch+8       ; 19 words

        .if ne textured
kRounds     = 2
        .else
kRounds     = 3
        .endc

        .macro  load_pixel reg, word
        ld      reg, word(pixel)
        .endm

        .macro  store_pixel reg, word
        st      reg, word(pixel)
        .endm

        .macro  next_row
        add     pixel, pixel, #kPixel
        .endm

        .macro  step_edge hi, lo, at, p, q
        step    hi, lo, at, p, q
        .endm

        .macro  step_intensity hi, lo, p, q
        step    hi, lo, n_intensity, p, q
        .endm

        .macro  drawn
        .endm

        .include "sample.s"

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

; Lanes that are done take their next descriptor, if they have one. Those that have none go back by the rows that they have gone down, so that
; they stay in their frame buffer.
        .macro  advance
        tgeu    pixel, pixels
        slf
        mov     pixels, r0
        sub     pixel, pixel, #samples*kPixel
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

; T := the lane has something left to draw.
        .macro  anything_left
        ld      r16, raster_next
        ld      r17, received_end
        tltu    pixel, pixels
        tltu.or r16, r17
        .endm

        .macro  rasterised
        setp    finish
        .endm

rasterise:
        wake
        phase   4
        ld      r1, received_at
        st      r1, raster_next
        mov     polygon, r1             ; lanes that have nothing must read somewhere
        mov     pixels, r0
        ld      pixel, drawing
        add     pixel, pixel, #samples*kPixel
        raster_words st
        setp    rasterise_some
        line

        .include "raster_loop.s"
