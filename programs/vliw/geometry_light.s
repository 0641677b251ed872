; SPDX-License-Identifier: MIT
; Geometry, second stage, part 1: white light at the vertices of a visible polygon (Eldridge 1995, 7.3.4),
;     I = ambient + sum over both lights, where n l > 0: diffuse (n l) + specular max(0, r v)^(2^shininess), at most 255.
; n: normal, turned like the object; l: unit vector towards the light, the lamp's to 4 units of its place; r = 2 (n l) n - l: the mirrored
; light; v = (0, 0, -1): the viewer, far away, so that r v = lz - 2 (n l) nz.
;
; Registers: r1 vertex in the database, r2 its eye coordinates (less d_eye), r3 where its intensity goes (less d_lit), r4 to r6 n,
; r30 the candidate. c0: vertices to come, c1: squarings.

; From facing = n l: highlight := max(0, r v), both 0 unless facing > 0. m: spoilt.
        .macro  mirror highlight, facing, lz, nz, m
        mul     highlight, facing, nz, 13
        sub     highlight, lz, highlight
        positive highlight, highlight, m
        sub     m, r0, facing
        mul     m, m, #1, 15
        and     facing, facing, m
        and     highlight, highlight, m
        .endm

; sum := sum + cosine * the light at `address`, in 1/16. t: spoilt.
        .macro  shed sum, cosine, address, t
        ld      t, address
        mul     t, t, cosine, 10
        add     sum, sum, t
        .endm

        .macro  load3 a, b, c, address
        ld      a, address
        ld      b, 1+address
        ld      c, 2+address
        .endm

; d := (the lamp's coordinate - the vertex's) / 4. t: spoilt.
        .macro  to_lamp d, k, t
        ld      d, k+lamp
        ld      t, k+d_eye(r2)
        mul     d, d, #1, 2
        mul     t, t, #1, 2
        sub     d, d, t
        .endm

light:
        wake
        ld      r30, next_slot
        ld      r31, slots_stop
        ld      r1, shininess
        add     r1, r1, #1
        put     r1
        tltu    r30, r31
        bor     1$
        leave_geometry
        line
1$:     slf
        ld      r1, d_polygon(r30)
        mov     r2, r30
        mov     r3, r30
        setc    c0, 3
2$:     load3   r7, r8, r9, 3(r1)
        load3   r10, r11, r12, eye_rows
        inner   r4, r10, r7, r11, r8, r12, r9, r13, r14
        load3   r15, r16, r17, eye_rows+kEyeRow
        inner   r5, r15, r7, r16, r8, r17, r9, r18, r19
        load3   r10, r11, r12, eye_rows+kEyeRow+kEyeRow
        inner   r6, r10, r7, r11, r8, r12, r9, r13, r14
        to_lamp r20, 0, r23
        to_lamp r21, 1, r24
        to_lamp r22, 2, r25
        load3   r10, r11, r12, sun
        unit_vector r20, r21, r22, r23, r24, r25, r26, r27, r28, r29
        inner   r13, r4, r10, r5, r11, r6, r12, r14, r15
        mirror  r14, r13, r12, r6, r15
        inner   r16, r4, r20, r5, r21, r6, r22, r17, r18
        mirror  r17, r16, r22, r6, r18
        ld      r7, ambient
        mul     r7, r7, #16
        shed    r7, r13, sun_diffuse, r8
        shed    r7, r16, lamp_diffuse, r9
        ldc     c1
        jump    4$
3$:     mul     r14, r14, r14, 14
        mul     r17, r17, r17, 14
4$:     dec     c1, 3$
        shed    r7, r14, sun_specular, r8
        shed    r7, r17, lamp_specular, r9
        at_most r7, r7, 255*16, r8
        mul     r7, r7, #16
        st      r7, d_lit(r3)
        add     r1, r1, #7
        add     r2, r2, #3
        add     r3, r3, #1
        dec     c0, 2$
