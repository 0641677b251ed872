; SPDX-License-Identifier: MIT
; Edges. An edge from vertex U down to V, h high and w wide, is on line y at x = (Ux h + (16 y - Uy) w) / 16 h pixels. The last
; pixel that is not right of it is x cut off downwards, the first one not left of it one more than (the numerator - 1) / 16 h cut
; off downwards. Numerators may be cut off to sixteenths first. From line to line x grows by w / h: a whole number and a
; remainder, and by one more when the remainders sum up to h.

; r0 = the quotient cut off downwards, r1 = the remainder, of 32 bits in r0:r1 and `divisor` > 0, a register.
        .macro  divide_down divisor, ?exact
        div     divisor, r0
        tst     r1
        bpl     exact
        dec     r0
        add     divisor, r1
exact:
        .endm

; Sets `side` (left or right) up on the edge from the vertex at r_u to the one at r_v, for the line at line_16, which the
; edge reaches. Clobbers r0 to r3.
        .macro  edge side, r_u, r_v, is_left
        mov     at_x(r_v), r3
        sub     at_x(r_u), r3
        mov     r3, edge_x
        mov     (r_v), r0
        sub     (r_u), r0
        mov     r0, side'_height
        mul     at_x(r_u), r0
        mov     line_16, r2
        sub     (r_u), r2
        mul     edge_x, r2
        add     r3, r1
        adc     r0
        add     r2, r0
        .if ne is_left
        sub     #1, r1
        sbc     r0
        .endc
        ashc    #-4, r0
        mov     side'_height, r2
        divide_down r2
        .if ne is_left
        inc     r0
        .endc
        sub     tile_left, r0
        mov     r0, side'_x
        sub     r2, r1
        mov     r1, side'_x+2
        mov     edge_x, r1
        sxt     r0
        divide_down r2
        mov     r0, side'_x_dy
        mov     r1, side'_x_dy+2
        .endm
