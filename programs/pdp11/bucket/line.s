; SPDX-License-Identifier: MIT
; The inner loop: a line of the triangle, its pixels in the tile.

; 32 bits, both just before r3 and r4, which stand at them afterwards.
        .macro  add_word_pair
        add     -(r3), -(r4)
        adc     -(r4)
        add     -(r3), (r4)
        .endm

        .macro  sub_word_pair
        sub     -(r3), -(r4)
        sbc     -(r4)
        sub     -(r3), (r4)
        .endm

; All values.
        .macro  for_values what
        what
        what
        .if ne textured
        what
        what
        .endc
        .endm

        .macro  next_line side, ?same
        add     -(r3), -(r4)            ; the remainder: negative until it comes to the edge's height
        bmi     same
        sub     side'_height, (r4)
        inc     -2(r4)
same:   add     -(r3), -(r4)
        .endm

; A value `r5` columns on. Clobbers r0, r1.
        .macro  move_value value
        mov     value+to_m, r0
        mul     r5, r0
        ashc    shift_x, r0
        add     r1, value+2
        adc     value
        add     r0, value
        .endm

tap_pixels_done:
pixels_done:
        mov     #dys_end, r3
        mov     #values_end, r4
        for_values add_word_pair
        br      sides_go_on
empty:  mov     #sides_dy_end, r3
        mov     #sides_end, r4
        tst     column
        bpl     pixels_done
sides_go_on:
        next_line right
        next_line left
        dec     lines
        bmi     end_of_edge
        inc     row

; In: the sides; row; the values at `column`.
tap_segment:
segment:
        mov     left_x, r0
        bpl     span
        clr     r0
span:   mov     right_x, r1
        cmp     r1, last_column
        ble     1$
        mov     last_column, r1
1$:     sub     r0, r1
        blt     empty
        inc     r1
        mov     r1, sp                  ; pixels
        mov     row, @#io_fbrow
        mov     r0, r5
        sub     column, r5              ; columns from the values' one
        bne     move
moved:  asl     r0
        mov     r0, r5
        add     #depth_window, r5
        .include "pixels.s"

end_of_edge:
        inc     row
        jmp     @edge_ended

; To column r0 from one that is r5 columns on its left. That one is -1 when there is none.
move:   tst     column
        bpl     2$
        jmp     planes
2$:     mov     r0, column
        mov     #dxs_end, r3
        mov     #values_end, r4
        cmp     r5, #1
        bne     3$
        for_values add_word_pair
        br      moved
3$:     cmp     r5, #-1
        bne     4$
        for_values sub_word_pair
        br      moved
4$:     mov     r0, r2
        move_value depth
        move_value shade
        .if ne textured
        move_value u
        move_value v
        .endc
        mov     r2, r0
        jmp     moved
