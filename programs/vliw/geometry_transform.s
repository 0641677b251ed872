; SPDX-License-Identifier: MIT
; Geometry, first stage, for every polygon of the database: to eye space, rejection, perspective, box, back face. Visible ones become
; candidates (geometry.s) in the array to be sent.
;
; Registers of the whole procedure: r27 -f, r28 the polygon, r29 its candidate, r30 near, r31 f. c0: polygons to come on the lane that
; has most; c1: those of this scanline.
kTransformsALine = 4            ; polygons

; l := coordinate `row` (0 x', 1 y', 2 z') of the vertex x, y, z, rounded; h := its 32-bit value's upper word, in units of 4.
        .macro  eye_coordinate row, l, h, x, y, z, m, t, u
        ld      m, <row*kEyeRow>+eye_rows
        product l, h, m, x
        ld      m, <row*kEyeRow>+1+eye_rows
        add_product l, h, m, y, t, u
        ld      m, <row*kEyeRow>+2+eye_rows
        add_product l, h, m, z, t, u
        ld      t, <row*kEyeRow>+3+eye_rows
        ld      u, <row*kEyeRow>+4+eye_rows
        add32   l, h, l, h, t, u
        mulu    l, l, #4, 16
        mul     t, h, #4, 0
        add     l, l, t
        .endm

; T := T and |coordinate| < z', by its upper word h and a quarter that is a little less than z' / 4: then the quotient fits s.15.
        .macro  within h, z, t, u
        mulu    u, z, #0x3ff8, 16
        add     t, h, u
        add     u, u, u
        tltu.and t, u
        .endm

; s := middle + f l / z' in 1/16 pixel, to the nearest; r: 2^28 / z'. The table's quotient is up to 3 too small or 1 too great; what its product
; with z' misses of f l and half a z', in quarters, mends it.
        .macro  project s, l, r, z, f, middle, t, u
        mulsu   s, l, r, 13
        mul     s, s, f, 15
        mul     t, l, f, 2
        mul     u, s, z, 2
        sub     t, t, u
        mulu    u, z, #0x2000, 16
        add     t, t, u
        mulsu   t, t, r, 26
        add     s, s, t
        add     s, s, #middle
        .endm

        .macro  load_vertex v, x, y, z
        ld      x, <7*v>(r28)
        ld      y, <7*v>+1(r28)
        ld      z, <7*v>+2(r28)
        .endm

; Vertex v in x, y, z: its screen coordinates, its part of the candidate; T := T and it is near enough and not too far from the middle. The rows
; take turns in the registers to work with, so that one's perspective goes beside the next one's products. `next` is done before the last store,
; so that the next vertex's work may begin.
        .macro  transform_vertex v, sx, sy, x, y, z, depth, r, m1, l1, h1, t1, u1, m2, l2, h2, t2, u2, next
        eye_coordinate 2, depth, h1, x, y, z, m1, t1, u1
        tltu.and h1, #0x2000
        tge.and depth, r30
        ld      r, reciprocals(depth)
        st      depth, <3*v>+2+d_eye(r29)
        st      r, v+d_reciprocals(r29)
        eye_coordinate 0, l2, h2, x, y, z, m2, t2, u2
        within  h2, depth, t2, u2
        st      l2, <3*v>+d_eye(r29)
        eye_coordinate 1, l1, h1, x, y, z, m1, t1, u1
        project sx, l2, r, depth, r31, 8*screen_columns, t2, u2
        within  h1, depth, t1, u1
        next
        st      l1, <3*v>+1+d_eye(r29)
        project sy, l1, r, depth, r27, 8*screen_rows, t1, u1
        .endm

; The whole pixels from the least to the greatest of a, b, c; T := T and there are some, and some of 0 ... size - 1 may be among them.
        .macro  box low, high, first, a, b, c, size, t, u
        span16  low, high, first, a, b, c, t, u
        add     low, low, #15
        mul     low, low, #1, 4
        mul     high, high, #1, 4
        tlt.and low, #size
        tge.and high, r0
        tge.and high, low
        .endm

; r31, r27, r30
        .macro  load_view
        ld      r31, focal
        sub     r27, r0, r31
        ld      r30, near
        .endm

; Lanes that have no further polygon fall asleep. T, r1, r2: spoilt.
        .macro  take_polygon
        wake
        .if ne sort_first
        ld      r1, next_polygon
        ld      r2, polygons_stop
        tltu    r1, r2
        slf
        lds     r28, 0, (r1)
        add     r1, r1, #1
        st      r1, next_polygon
        .else
        ld      r1, polygons_stop
        tltu    r28, r1
        slf
        .endc
        .endm

; Everybody awake, unless some lane has a further polygon: then on at `more`.
        .macro  if_more more
        .if ne sort_first
        wake
        ld      r1, next_polygon
        ld      r2, polygons_stop
        tltu    r1, r2
        bor     more
        .else
        dec     c0, more
        wake
        .endc
        .endm

; T := the polygon r28 is visible. Its box's columns in r11 and r12, not yet within the screen; twice its area, 32 bits, in r8, r9; its screen
; coordinates in r21 ... r26. Box, eye coordinates and reciprocals are in the candidate. `loads` is done before the box is stored.
        .macro  transform_polygon loads
        load_vertex 0, r1, r2, r3
        transform_vertex 0, r21, r22, r1, r2, r3, r9, r10, r4, r5, r6, r7, r8, r14, r15, r16, r17, r18, <load_vertex 1, r11, r12, r13>
        transform_vertex 1, r23, r24, r11, r12, r13, r19, r20, r14, r15, r16, r17, r18, r4, r5, r6, r7, r8, <load_vertex 2, r1, r2, r3>
        transform_vertex 2, r25, r26, r1, r2, r3, r9, r10, r4, r5, r6, r7, r8, r14, r15, r16, r17, r18
        loads
        box     r11, r12, r13, r21, r23, r25, screen_columns, r14, r15
        st      r11, d_left(r29)
        st      r12, d_right(r29)
        box     r1, r2, r3, r22, r24, r26, screen_rows, r4, r5
        st      r1, d_top(r29)
        st      r2, d_bottom(r29)
        sub     r6, r21, r25            ; twice the area: (sy0 - sy1) (sx0 - sx2) - (sx0 - sx1) (sy0 - sy2)
        sub     r7, r22, r26
        product r8, r9, r3, r6
        sub_product r8, r9, r13, r7, r16, r17
        less32  r0, r0, r8, r9, r10, .and
        .endm

        .macro  load_array
        ld      r19, source_count
        ld      r20, last_slot
        .endm

transform:
        wake
        setc    c1, kTransformsALine
        load_view
        .if eq sort_first
        ld      r28, next_polygon
        .endc
        ld      r29, next_slot
1$:     take_polygon
        transform_polygon load_array
        sends   r11, r14, r15, r16
        st      r8, d_area(r29)
        st      r9, d_area+1(r29)
        st      r21, d_screen+0(r29)
        st      r22, d_screen+1(r29)
        st      r23, d_screen+2(r29)
        st      r24, d_screen+3(r29)
        st      r25, d_screen+4(r29)
        st      r26, d_screen+5(r29)
        st      r28, d_polygon(r29)
        .if eq sort_first
        add     r28, r28, #kPolygon
        .endc

        slf                             ; the visible ones
        teq     r29, #spare_slot
        bor     array_full
        add     r29, r29, #kDescriptor
        add     r19, r19, #1
        st      r29, slots_stop
        st      r19, source_count
        tltu    r20, r29
        slf
        mov     r29, #spare_slot
        if_more 2$
        ld      r1, source_at
        st      r1, next_slot
        setp    light
        line
2$:     dec     c1, 1$
        wake
        .if eq sort_first
        st      r28, next_polygon
        .endc
        st      r29, next_slot
        line

array_full:
        slf
        mov     r1, #1
        st      r1, error
        halt
