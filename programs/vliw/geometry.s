; SPDX-License-Identifier: MIT
; Geometry (Eldridge 1995, 7.3): from a lane's database to its array of descriptors to be sent, in two stages (3.2.2, figure 3-13):
;   `transform` goes over all polygons and keeps the visible ones (geometry_transform.s); each gets its place in the array, and there
;               what has been found out about it: see `candidate`;
;   `light`     goes over these and makes them descriptors (geometry_light.s, geometry_planes.s).
; `geometry` is the entry; main has the label `communicate`, where it goes on. textured = 0 leaves u and v out.
; boxes = 1 leaves everything out: what the host has put into the array is sent as it is.
; With sort_first the polygons are those that the list `wanted` names, and the descriptors stay: main has the label `normalise`.
; A lane whose array is full when one more polygon is visible sets `error` to 1, and the machine halts.

        .include "memory.s"
        .include "arithmetic.s"
        .include "duplicate.s"
        .if ne sort_first
        .include "wanted.s"
        .endc
        .if ndf textured
textured = 1
        .endc

; geometry_scratch
eye_rows    = geometry_scratch  ; a row of the matrix: 3 words s1.14, then its integer, times 2^14 and half a unit, 32 bits
kEyeRow     = 5
next_polygon = geometry_scratch+15      ; transform's next one, with sort_first its place in a list
polygons_stop = geometry_scratch+16     ; first word behind the database or list
next_slot   = geometry_scratch+17       ; where the next visible polygon goes, then: which one to light
slots_stop  = geometry_scratch+18       ; first word behind the visible ones
last_slot   = geometry_scratch+19       ; the last place where a descriptor has room
words_x     = geometry_scratch+20       ; two products of four words each
words_y     = geometry_scratch+24
spare_slot  = geometry_scratch+28       ; takes the place of slots behind the array

; A candidate: a visible polygon between the stages, in its descriptor's place
d_polygon   = 4                 ; its address in the database
d_area      = 6                 ; twice its area, in 1/256 pixel, 32 bits
d_screen    = 8                 ; sx, sy of each vertex
d_eye       = 14                ; x', y', z' of each vertex
d_reciprocals = 23              ; 2^28 / z' of each vertex
d_lit       = 26                ; intensity of each vertex, 8.8
kCandidate  = 29
        .iif gt spare_slot+kCandidate-other_scratch, .error the geometry's scratch is too small

; The matrix is copied: a new one may come while geometry is at work. r1 ... r5: spoilt.
        .macro  copy_matrix
        .irp row, <0, 1, 2>
        .irp k, <0, 1, 2>
        ld      r2, <row*3>+k+matrix
        st      r2, <row*kEyeRow>+k+eye_rows
        .endr
        ld      r3, row+9+matrix
        shl     r4, r3, #14
        asr     r5, r3, #2
        add     r4, r4, #0x2000
        st      r4, <row*kEyeRow>+3+eye_rows
        st      r5, <row*kEyeRow>+4+eye_rows
        .endr
        .endm

; From light, with slots_stop in r31.
        .macro  leave_geometry
        .if ne sort_first
        ld      r2, source_at
        ld      r3, source_count
        st      r2, received_at
        st      r31, received_end
        st      r3, receive_count
        setp    normalise
        .else
        setp    communicate
        .endc
        .endm

; Prepares transform.
geometry:
        wake
        .if ne boxes
        setp    communicate
        line
        .endc
        setp    transform
        .if ne sort_first
        phase   1                       ; sort_homes has copied the matrix
        mov     r7, #wanted
        ld      r6, wanted_end
        .else
        ld      r1, most
        put     r1
        ldc     c0
        copy_matrix
        ld      r6, polygons
        ld      r7, polygons_at
        mul     r6, r6, #kPolygon
        add     r6, r6, r7
        .endc
        st      r7, next_polygon
        st      r6, polygons_stop
        ld      r8, source_at
        ld      r9, source_end
        sub     r9, r9, #kDescriptor
        st      r8, slots_stop
        st      r9, last_slot
        st      r0, source_count
        tltu    r9, r8
        slf
        mov     r8, #spare_slot
        wake
        st      r8, next_slot
        .if eq sort_first
        tne     r1, r0
        bt      1$
        setp    communicate
1$:
        .endc
        line

        .include "geometry_transform.s"
        .include "geometry_light.s"
        .include "geometry_planes.s"
