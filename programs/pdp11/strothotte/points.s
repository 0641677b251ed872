; SPDX-License-Identifier: MIT
; POINTS: place and intensity of every crossing of every facet held here; the points go to all neighbours.
;
; The facet's place and normals are kept in virtual cylinder coordinates (along the radius, along phi, along the axis), in
; which a rotation changes nothing but the longitude phi. The processor knows the screen's axes and the light in the
; same coordinates at its own longitude; they are turned by the small angle between the facet's longitude and the processor's.

points: doing   mark_points
        mov     facet_list, r5
        beq     2$
1$:     mov     r5, facet
        call    facet_axes
        call    facet_points
        mov     #-1, r4
        mov     port_count, @#io_credit
        call    send_all
        mov     facet, r5
        mov     b_link(r5), r5
        bne     1$
2$:     return

; r0 = the part along the facet's radius of a vector whose parts at the processor are given. Clobbers r1 to r3.
        .macro  radial_part rho, phi
        mov     rho, r0
        mul     cosine, r0
        mov     phi, r2
        mul     sine, r2
        add32
        to14    r0, r1
        .endm

; r0 = its part along the facet's phi.
        .macro  phi_part rho, phi
        mov     phi, r0
        mul     cosine, r0
        mov     rho, r2
        mul     sine, r2
        sub     r3, r1
        sbc     r0
        sub     r2, r0
        to14    r0, r1
        .endm

; r0 = part along the facet's own direction, of a vector with r0 along the facet's radius and z along the axis.
        .macro  outward_part z
        mul     f_sin(r5), r0
        mov     z, r2
        mul     f_cos(r5), r2
        add32
        to14    r0, r1
        .endm

; The screen's axes and the light as the facet in r5 sees them. Clobbers r0 to r3.
facet_axes:
        mov     f_phi(r5), r0
        sub     here_phi, r0
        call    sin_cos
        radial_part right_rho, right_phi
        outward_part right_z
        mov     r0, out_right
        radial_part down_rho, down_phi
        outward_part down_z
        mov     r0, out_down
        radial_part away_rho, away_phi
        mov     r0, facet_away_rho
        outward_part away_z
        mov     r0, out_away
        phi_part away_rho, away_phi
        mov     r0, facet_away_phi
        radial_part light_rho, light_phi
        mov     r0, facet_light_rho
        phi_part light_rho, light_phi
        mov     r0, facet_light_phi
        return

; A block with the points of the facet in r5, known to the table of points; r5 points to it. Clobbers all.
facet_points:
        mov     r5, r4
        call    get_block
        mov     #kind_points, (r5)
        mov     f_id(r4), p_id(r5)
        movb    f_cross(r4), r0
        mov     r0, points_left
        mov     r0, p_count(r5)
        asl     r0
        asl     r0
        asl     r0
        add     #p_body, r0
        mov     r0, b_length(r5)
        call    add_points
        mov     r5, -(sp)
        add     #f_body, r4
        add     #p_body, r5
1$:     call    place
        call    shade
        dec     points_left
        bne     1$
        mov     (sp)+, r5
        return

; x, y and depth of the crossing at (r4) to (r5): scaling, translation, perspective. r4 moves to its normal, r5 to the
; point's intensity. Clobbers r0 to r3.
place:  mov     (r4)+, r2
        fmul    scale, r2, r3
        mov     r2, scaled_radius
        mov     r2, r0
        fmul    out_away, r0, r1
        add     shift_away, r0
        mov     r0, distance
        ash     divisor_shift, r0
        add     divisor_base, r0
        mov     r0, r2                  ; proportional to 1 + d/h
        mov     dividend, r0
        mov     dividend+2, r1
        div     r2, r0
        mov     r0, shrink
        mov     scaled_radius, r0
        fmul    out_right, r0, r1
        add     shift_right, r0
        call    project
        add     centre_x, r0
        mov     r0, (r5)+
        mov     scaled_radius, r0
        fmul    out_down, r0, r1
        add     shift_down, r0
        call    project
        add     centre_y, r0
        mov     r0, (r5)+
        mov     distance, r0
        call    project
        mov     r0, (r5)+
        return

; r0 (s1.14) times the perspective factor, in 13 bits of fraction: the screen's 1/64 pixel, or s2.13. Clobbers r1.
project:
        mul     shrink, r0
        ashc    shrink_shift, r0
        rol     r1
        adc     r0
        return

; r0:r1 = the product of the normal at (r4) with a vector. Clobbers r2, r3.
        .macro  normal_times rho, phi, z
        mov     (r4), r0
        mul     rho, r0
        mov     2(r4), r2
        mul     phi, r2
        add32
        mov     4(r4), r2
        mul     z, r2
        add32
        .endm

; Edge-on counts as looking away: above -1/512, high word of s2.28.
edge_on = -8.

; Intensity of the crossing whose normal is at (r4), to (r5)+; bit 15: its surface looks away. r4 moves behind the
; normal. Clobbers r0 to r3.
shade:  normal_times facet_light_rho, facet_light_phi, light_z
        bmi     1$
        to14    r0, r1
        fmul    diffuse, r0, r1
        add     ambient, r0
        br      2$
1$:     mov     ambient, r0
2$:     mov     r0, (r5)
        normal_times facet_away_rho, facet_away_phi, away_z
        cmp     r0, #edge_on
        blt     3$
        bis     #100000, (r5)
3$:     tst     (r5)+
        add     #6, r4
        return
