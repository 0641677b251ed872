; SPDX-License-Identifier: MIT
; Linear equations normalised to the lane's region (Eldridge 1995, 7.5.1): of every descriptor that the lane draws, in place. `normalise` brings
; their origin to the row d_top of the column before the first one that is drawn: the rasteriser begins a column with a step to it.
; If there are several bands, `band` goes over all descriptors for each of them, lists those that meet it and brings the origin of what
; began above the band to its first row.
; deferred: only edges and depth, the other parameters stay as they came, for shade.s.
; Registers: r1 descriptor, r2 columns and r3 rows by which the origin moves, r4 first address behind the list, r5 ... r29 arithmetic, r30 place
; in the list. Memory: normal_next. Counter: c4. Lanes that have no more descriptors sleep.

normal_next = other_scratch+6           ; place in the list of the next descriptor
kNormalised = 8                         ; on a scanline

; The descriptor, normalised; the rest is where it was, as in memory.s.
n_origin    = d_top                     ; row of the origin
n_bottom    = d_bottom
n_base      = 6                         ; address of the band's first row in the column of the origin as it is before any column is drawn
n_columns   = 7                         ; columns to be drawn

        .include "descriptor.s"

        .macro  move_edge at, a, b, hi, lo, p, q
        edge_value r1, at, r2, r3, hi, lo, a, b, p, q
        st      lo, at+2(r1)
        st      hi, at+3(r1)
        .endm

        .macro  move_long at, bias, hi, lo, ah, al, bh, bl, p, q
        long_value r1, at, r2, r3, bias, hi, lo, ah, al, bh, bl, p, q
        st      lo, at+4(r1)
        st      hi, at+5(r1)
        .endm

; What bands move, too; bias: see long_value.
        .macro  move_all bias
        move_edge d_edges, r5, r6, r7, r8, r9, r10
        move_edge d_edges+4, r11, r12, r13, r14, r15, r16
        move_edge d_edges+8, r17, r18, r19, r20, r21, r22
        move_long d_depth, 0, r23, r24, r25, r26, r27, r28, r29, r5
        .if ne textured
        .if eq deferred
        move_long d_u, bias, r5, r6, r7, r8, r9, r10, r11, r12
        move_long d_v, bias, r13, r14, r15, r16, r17, r18, r19, r20
        .endc
        .endc
        .endm

; From column and row to the next of the list.
        .macro  begin_some
        wake
        ld      r30, normal_next
        ld      r4, wanted_end
        setc    c4, kNormalised
        tltu    r30, r4
        .endm

        .macro  finish_some name, next, save
        add     r30, r30, #1
        tltu    r30, r4
        bnor    name'_done
        dec     c4, name'_loop
        jump    name'_save
name'_done:
        setp    next
name'_save:
        wake
        save
        st      r30, normal_next
        line
        .endm

        .macro  first_of_list
        mov     r30, #wanted
        st      r30, normal_next
        .endm

; row_next := the lesser of row_next and `by`. t, u, v: to work with.
        .macro  lower_row_next by, t, u, v
        ld      t, row_next
        sub     u, by, t
        mul     v, u, #1, 15
        and     u, u, v
        add     t, t, u
        st      t, row_next
        .endm

        .macro  no_row_next
        mov     r5, #kNoRow
        st      r5, row_next
        .endm

normalise:
        wake
        phase   3
        .if ne fragments
        no_row_next
        .endc
        first_of_list
        setp    normalise_some
        line

normalise_some:
        begin_some
normalise_loop:
        slf
        lds     r1, 0, (r30)
        ld      r5, region_left
        ld      r6, region_right
        ld      r7, d_left(r1)
        ld      r8, d_right(r1)
        ld      r3, d_top(r1)
        sub     r7, r7, r5              ; the box's part of the region, from its left
        positive r7, r7, r9
        sub     r8, r8, r6
        mul     r9, r8, #1, 15
        and     r8, r8, r9
        add     r8, r8, #kRegionColumns
        sub     r8, r8, r7
        sub     r7, r7, #1
        add     r2, r7, r5
        mul     r10, r7, #band_rows
        normalise_colours r1, r20, r21, r24, r25, r26, r27
        st      r10, n_base(r1)
        st      r8, n_columns(r1)
        move_all kUBias
        .if eq deferred
        intensity_value r1, r2, r3, r13, r15, r5, r6, r8, r7, r9, r10
        st      r15, n_intensity+2(r1)
        st      r13, n_intensity+3(r1)
        .endc
        .if gt bands-1
        .if ne fragments
        lower_row_next r3, r16, r17, r18
        .endc
        finish_some normalise, begin_band
        .else
        finish_some normalise, rasterise
        .endc

        .if gt bands-1
begin_band:
        wake
        phase   3
        .if ne fragments
        ld      r6, row_next
        add     r7, r6, #band_rows-1
        st      r6, row_first
        st      r7, row_last
        no_row_next
        .endc
        first_of_list
        begin_list banded, banded_end
        setp    band
        line

; The scaled intensity by r2 columns and r3 rows: 2^14 (A columns + B rows), A and B s7.8.
        .macro  move_intensity a, b, hi, lo, p, q
        ld      a, n_intensity(r1)
        ld      b, n_intensity+1(r1)
        mov     lo, r0
        mov     hi, r0
        add_product hi, lo, a, r2, p, q
        add_product hi, lo, b, r3, p, q
        shl     hi, hi, #14
        shr     p, lo, #2
        or      hi, hi, p
        shl     lo, lo, #14
        ld      p, n_intensity+2(r1)
        ld      q, n_intensity+3(r1)
        adds    lo, lo, p
        adc     hi, hi, q
        st      lo, n_intensity+2(r1)
        st      hi, n_intensity+3(r1)
        .endm

; A descriptor that began above this band has been drawn in the one before: its origin has gone through all its columns.
band:
        begin_some
        ld      r31, banded_end
band_loop:
        slf
        lds     r1, 0, (r30)
        ld      r5, row_first
        ld      r6, row_last
        ld      r7, n_origin(r1)
        ld      r8, n_bottom(r1)
        ld      r9, n_columns(r1)
        sts     r1, 0, (r31)
        tge     r6, r7
        tge.and r8, r5
        tget    r10
        add     r31, r31, r10
        tlt.and r7, r5
        tget    r11
        sub     r3, r5, r7
        mul     r3, r3, r11
        mul     r2, r9, r11
        sub     r2, r0, r2
        add     r7, r7, r3
        st      r7, n_origin(r1)
        .if ne fragments
        add     r12, r6, #1             ; where it goes on below this band, if it does
        sub     r13, r7, r12
        positive r13, r13, r14
        add     r12, r12, r13
        tlt     r6, r8
        tget    r13
        sub     r12, r12, #kNoRow
        mul     r12, r12, r13
        add     r12, r12, #kNoRow
        lower_row_next r12, r13, r14, r15
        .endc
        move_all 0
        .if eq deferred
        move_intensity r5, r6, r7, r8, r9, r10
        .endc
        finish_some band, rasterise, <st r31, banded_end>
        .endc
