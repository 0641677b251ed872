; SPDX-License-Identifier: MIT
; Which neighbour a message goes to next, by its angles (topologies/routing.hpp is the exact specification). Small-circle
; routing follows the straight line in the (phi, theta) plane; great-circle routing takes the neighbour nearest to the target.
; Facets use virtual coordinates, whose pole is the axis of rotation; triangles use those of the screen.
;
; A processor's routing record, one for each kind of coordinates:
r_phi      = 0                  ; angle, longitude here
r_theta    = 2                  ; angle, colatitude of the middle of the arrival rectangle
r_wide     = 4                  ; angle, half its width
r_high     = 6                  ; angle, half its height
r_polar    = 10                 ; not 0: the pole is in this processor's region
r_vectors  = 12                 ; address of directions, three words s1.14 each: own, then the neighbours' in port order
r_sectors  = 14                 ; pairs: greatest slope (unsigned), twice the port's number; the last slope is 177777

; Distances r0 = dphi, r1 = dtheta, r2 and r3 their magnitudes; when within the arrival rectangle, goes to `inside`.
        .macro  rectangle inside
        sub     r_phi(r4), r0
        mov     r0, r2
        bpl     21$
        neg     r2
21$:    sub     r_theta(r4), r1
        mov     r1, r3
        bpl     22$
        neg     r3
22$:    cmp     r2, r_wide(r4)
        bhi     23$
        cmp     r3, r_high(r4)
        blos    inside
23$:
        .endm

; In: r5 a FACET. Out: r3 twice the port, or -1: it has arrived. Clobbers r0 to r4.
route_facet:
        mov     f_phi(r5), r0
        mov     f_theta(r5), r1
        mov     virtual_route, r4
        tst     great_circle
        beq     small_circle
        mov     f_x(r5), goal_x
        mov     f_y(r5), goal_y
        mov     f_cos(r5), goal_z
        br      great

; In: r5 a TRIANGLE. As above.
route_by_angles:
        mov     t_phi(r5), r0
        mov     t_theta(r5), r1
        mov     screen_route, r4
        tst     great_circle
        beq     small_circle
        mov     t_vx(r5), goal_x
        mov     t_vy(r5), goal_y
        mov     t_vz(r5), goal_z

; In: r0 phi, r1 theta and goal_x, goal_y, goal_z of the target, r4 the record. Out: r3. Clobbers r0 to r4.
great:  rectangle great_arrived
        mov     r_vectors(r4), r4
        mov     #-1, best_port
        call    dot
        mov     r0, best
        mov     r1, best+2
        clr     port
1$:     call    dot
        cmp     r0, best
        blt     3$
        bgt     2$
        cmp     r1, best+2
        blos    3$
2$:     mov     r0, best
        mov     r1, best+2
        mov     port, best_port
3$:     add     #2, port
        cmp     port, last_port
        ble     1$
        mov     best_port, r3
        return
great_arrived:
        mov     #-1, r3
        return

; r0:r1 = (r4)+ times the goal.
dot:    mov     (r4)+, r0
        mul     goal_x, r0
        mov     (r4)+, r2
        mul     goal_y, r2
        add32
        mov     (r4)+, r2
        mul     goal_z, r2
        add32
        return

; In: r0 phi, r1 theta of the target, r4 the record, arrival_port. Out: r3. Clobbers r0 to r4.
small_circle:
        rectangle arrived
        tst     r_polar(r4)
        bne     3$                     ; only the longitude counts
        mov     r0, -(sp)
        mov     r1, -(sp)
        clc
        ror     r2
        clc
        ror     r3
        add     r3, r2
        bne     1$
        clr     r0
        br      2$
1$:     mov     r3, r0                  ; slope: |dtheta| / (|dphi| + |dtheta|), 40000 a quarter turn
        clr     r1
        ashc    #-2, r0
        div     r2, r0
2$:     tst     (sp)+
        bpl     4$
        neg     r0
4$:     tst     (sp)+
        bpl     3$
        neg     r0
        add     #100000, r0
3$:     add     #r_sectors-2, r4
5$:     tst     (r4)+
        cmp     r0, (r4)+
        bhi     5$
        mov     (r4), r3
        cmp     r3, arrival_port        ; to and fro between two processors: stay
        beq     arrived
        return
arrived:
        mov     #-1, r3
        return
