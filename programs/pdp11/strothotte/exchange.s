; SPDX-License-Identifier: MIT
; The table of points this processor knows: its own facets' and those the neighbours sent. point_id and point_block are
; parallel arrays of point_top/2 entries; the entry behind them is free for the search's sentinel and has block 0.

max_points = 64.

; Points of a neighbour's facet.
points_in:
        call    add_points
        mov     #-1, @#io_credit
        return

; Keeps block r5. Clobbers r0.
add_points:
        mov     point_top, r0
        cmp     r0, #2*max_points
        bhis    1$
        mov     p_id(r5), point_id(r0)
        mov     r5, point_block(r0)
        add     #2, r0
        clr     point_block(r0)
        mov     r0, point_top
        return
1$:     mov     #fault_points, @#io_fault
        return

; In: r0 a facet's number. Out: r0 the block with its points, or 0. Clobbers r1.
locate: mov     point_top, r1
        mov     r0, point_id(r1)
        mov     #point_id, r1
1$:     cmp     r0, (r1)+
        bne     1$
        mov     point_block-point_id-2(r1), r0
        return

; Frees all. Clobbers r1, r5.
forget_points:
        mov     point_top, r1
        beq     2$
1$:     sub     #2, r1
        mov     point_block(r1), r5
        call    free_block
        tst     r1
        bne     1$
2$:     clr     point_top
        clr     point_block
        return
