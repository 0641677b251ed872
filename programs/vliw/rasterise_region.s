; SPDX-License-Identifier: MIT
; Rasterising by half-planes in a region (Eldridge 1995, 3.2.3, 7.5.2, 7.5.3): a lane walks down one column of a descriptor's box after the other, then takes
; the next descriptor, in the form that normalise_region.s has given them. Pixels: region.s.
;
; Where a column begins the equations are brought one column to the right, in the descriptor, too: so the next begins with them.
; Lanes are decoupled: after every `samples` rows those that are done with a column begin the next; decoupled 0: they wait for each other.
; early_abort 1: a row outside behind one inside ends the column, since triangles are convex.
; Line-locked: kRounds times `samples` rows on a scanline. Memory: raster_* keeps sample.s' registers from scanline to scanline. Counter: c5.

raster_next = other_scratch+7           ; place in the list of the next descriptor to be taken
raster_at   = other_scratch+8           ; 19 words
raster_columns = other_scratch+28       ; columns still to be begun
raster_top  = other_scratch+29          ; address of the column's first row
raster_rows = other_scratch+30          ; its rows in this band
fragments_end = other_scratch+31        ; behind the list of drawn pixels

        .if ne textured&<1-deferred>
kRounds     = 1
        .else
kRounds     = 2
        .endc

        .macro  load_pixel reg, word
        lds     reg, word+1, (pixel)
        .endm

        .macro  store_pixel reg, word
        sts     reg, word+1, (pixel)
        .endm

        .macro  next_row
        add     pixel, pixel, #1
        .endm

        .macro  step_edge hi, lo, at, p, q
        ld      p, at+1(polygon)
        mul     q, p, #1, 15
        adds    lo, lo, p
        adc     hi, hi, q
        .endm

        .macro  step_intensity hi, lo, p, q
        ld      q, n_intensity+1(polygon)
        mul     p, q, #0x4000, 0
        mul     q, q, #0x4000, 16
        adds    lo, lo, p
        adc     hi, hi, q
        .endm

; Fragments: a pixel goes into the list when it is drawn for the first time.
        .macro  drawn
        .if ne fragments
        load_pixel r22, 0
        ld      r23, fragments_end
        sts     pixel, 0, (r23)
        teq     r22, r0
        tget    r22
        add     r23, r23, r22
        st      r23, fragments_end
        .endc
        .endm

        .include "sample.s"

        .macro  raster_words op
at = raster_at
        .irp    reg, <e0h, e0l, e1h, e1l, e2h, e2l, zh, zl, pixel, pixels, polygon, inside0>
        op      reg, at
at = at+1
        .endr
        .if eq deferred
        .irp    reg, <ih, il>
        op      reg, at
at = at+1
        .endr
        .if ne textured
        .irp    reg, <uh, ul, vh, vl>
        op      reg, at
at = at+1
        .endr
        .endc
        .endc
        .endm

; hi:lo := the value at the column to the right, in the descriptor, too.
        .macro  next_column hi, lo, at, al, ah
        ld      lo, at(polygon)
        ld      hi, at+1(polygon)
        adds    lo, lo, al
        adc     hi, hi, ah
        st      lo, at(polygon)
        st      hi, at+1(polygon)
        .endm

        .macro  next_edge hi, lo, at, al, ah
        ld      al, at(polygon)
        mul     ah, al, #1, 15
        next_column hi, lo, at+2, al, ah
        .endm

        .macro  next_long hi, lo, at, al, ah
        ld      al, at(polygon)
        ld      ah, at+1(polygon)
        next_column hi, lo, at+4, al, ah
        .endm

        .macro  next_intensity hi, lo, al, ah
        ld      ah, n_intensity(polygon)
        mul     al, ah, #0x4000, 0
        mul     ah, ah, #0x4000, 16
        next_column hi, lo, n_intensity+2, al, ah
        .endm

; Lanes that are done with all columns take their next descriptor, if they have one.
        .macro  advance_descriptor
        tgeu    pixel, pixels
        ld      r16, raster_columns
        teq.and r16, r0
        slf
        mov     pixels, r0
        ld      r16, raster_next
        ld      r17, raster_list_end
        tltu    r16, r17
        slf
        lds     polygon, 0, (r16)
        add     r16, r16, #1
        st      r16, raster_next
        ld      r22, n_columns(polygon)
        ld      r23, n_base(polygon)
        ld      r24, n_origin(polygon)
        ld      r25, n_bottom(polygon)
        ld      r26, row_first
        ld      r27, row_last
        sub     r28, r24, r26
        add     r23, r23, r28
        sub     r25, r25, r27           ; the lesser of the two
        mul     r29, r25, #1, 15
        and     r25, r25, r29
        add     r25, r25, r27
        sub     r25, r25, r24
        add     r25, r25, #1
        st      r22, raster_columns
        st      r23, raster_top
        st      r25, raster_rows
        wake
        .endm

; Lanes that are done with a column begin the next.
        .macro  advance_column
        tgeu    pixel, pixels
        ld      r16, raster_columns
        tne.and r16, r0
        slf
        sub     r16, r16, #1
        st      r16, raster_columns
        ld      pixel, raster_top
        ld      r17, raster_rows
        add     pixel, pixel, #band_rows
        st      pixel, raster_top
        add     pixels, pixel, r17
        next_edge e0h, e0l, n_edges, r22, r23
        next_edge e1h, e1l, n_edges+4, r24, r25
        next_edge e2h, e2l, n_edges+8, r26, r27
        next_long zh, zl, d_depth, r28, r29
        .if eq deferred
        next_intensity ih, il, r22, r23
        .if ne textured
        next_long uh, ul, d_u, r24, r25
        next_long vh, vl, d_v, r26, r27
        .endc
        .endc
        mov     inside0, r0
        wake
        .endm

        .if gt bands-1
raster_list = banded
raster_list_end = banded_end
        .else
raster_list = wanted
raster_list_end = wanted_end
        .endc

; T := the lane has something left to draw.
        .macro  anything_left
        ld      r16, raster_next
        ld      r17, raster_list_end
        ld      r22, raster_columns
        tltu    pixel, pixels
        tltu.or r16, r17
        tne.or  r22, r0
        .endm

        .macro  advance
        advance_descriptor
        advance_column
        .endm

        .macro  rasterised
        setp    composite
        .endm

rasterise:
        wake
        phase   4
        mov     r1, #raster_list
        st      r1, raster_next
        st      r0, raster_columns
        .if ne fragments
        mov     r2, #kGathered
        st      r2, fragments_end
        .endc
        mov     polygon, r0             ; lanes that have nothing must read somewhere
        mov     pixels, r0
        raster_words st
        setp    rasterise_some
        line

        .include "raster_loop.s"
