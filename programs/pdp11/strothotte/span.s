; SPDX-License-Identifier: MIT
; A run of pixels on a scanline: this processor's part goes into its z-buffer, the parts on either side go to the processors
; which own the pixels there, and they do the same.

span_in:
        doing   mark_span
        mov     s_path(r5), r0
        com     r0
        bit     #7, r0
        beq     span_here
        jmp     follow

; The span in r5, whose path is used up. Clobbers all.
span_here:
        movb    s_y(r5), r0
        bic     #177400, r0
        sub     top_row, r0
        cmp     r0, row_count
        bhis    other_row
        ash     #4, r0
        add     row_table, r0
        mov     r0, r4
        movb    s_first(r5), r1
        bic     #177400, r1
        movb    s_last(r5), r2
        bic     #177400, r2
        cmp     r1, w_first(r4)
        blt     part_here
        cmp     r2, w_last(r4)
        bgt     part_here
        call    plot                    ; all of it is this processor's
span_done:
        mov     #-1, @#io_credit
        jmp     free_block
part_here:
        mov     w_left(r4), r0
        cmp     r2, w_first(r4)
        blt     hand_over               ; all of it is to the left
        mov     w_right(r4), r0
        cmp     r1, w_last(r4)
        bgt     hand_over
        call    split
        beq     span_done
hand_over:
        mov     r0, s_path(r5)
        jmp     follow
other_row:
        tst     r0
        bmi     2$
        mov     path_down, r0
        br      hand_over
2$:     mov     path_up, r0
        br      hand_over

; The span in r5, columns r1 to r2, has pixels on the row with record r4: draws them and hands over those to the left. Out:
; r0 the path for those to the right, which the span holds then, or 0; flags as of r0. Clobbers r1 to r4.
split:  cmp     r1, w_first(r4)
        bge     2$
        call    left_part
        mov     w_first(r4), r1
2$:     mov     r2, span_last
        cmp     r2, w_last(r4)
        ble     3$
        mov     w_last(r4), r2
3$:     mov     r4, span_row
        call    plot
        mov     span_row, r4
        cmp     span_last, w_last(r4)
        ble     4$
        mov     r0, s_z(r5)             ; plot has moved the start there
        mov     r1, s_z+2(r5)
        movb    w_last(r4), s_first(r5)
        incb    s_first(r5)
        mov     w_right(r4), r0         ; never 0
        return
4$:     clr     r0
        return

; Sends off the pixels of the span in r5 that lie left of row record r4, and moves the span's start to there.
; In: r1 the first column. Clobbers r0, r1, r3.
left_part:
        mov     r2, -(sp)
        mov     r4, -(sp)
        mov     w_left(r4), s_path(r5)
        mov     w_first(r4), r4
        mov     r4, r0
        dec     r0
        movb    r0, s_last(r5)
        sub     r1, r4                  ; how many pixels
        mov     #1, @#io_credit
        call    follow_copy
        movb    r2, s_last(r5)
        mov     s_di(r5), r1
        mul     r4, r1
        add     r1, s_i(r5)
        mov     s_dz+2(r5), r2
        mul     r4, r2                  ; the fraction is unsigned:
        tst     s_dz+2(r5)
        bpl     1$
        add     r4, r2
1$:     mov     s_dz(r5), r1
        mul     r4, r1
        add     r1, r2
        add     r3, s_z+2(r5)
        adc     s_z(r5)
        add     r2, s_z(r5)
        mov     (sp)+, r4
        mov     (sp)+, r2
        return

; Columns r1 to r2 of the row with record r4, from the start of the span in r5. Out: r0:r1 the depth behind the last one,
; s_i the intensity there. Clobbers r2, r3, r4.
plot:   sub     r1, r2
        inc     r2
        sub     w_first(r4), r1
        mov     r1, r3
        add     w_grey(r4), r3
        asl     r1
        add     w_z(r4), r1
        mov     r2, r4
        mov     r1, r2
        mov     s_z(r5), r0
        mov     s_z+2(r5), r1
1$:     cmp     r0, (r2)+
        bge     2$                      ; hidden
        mov     r0, -2(r2)
        movb    s_i+1(r5), (r3)
2$:     inc     r3
        add     s_dz+2(r5), r1
        adc     r0
        add     s_dz(r5), r0
        add     s_di(r5), s_i(r5)
        sob     r4, 1$
        return
