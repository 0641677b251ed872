; SPDX-License-Identifier: MIT
; Sparse sort-last (Eldridge 1995, 3.2.1, 4.3.4): every lane sends what it has drawn of a band, pixel by pixel, to the lanes that draw the pixels'
; columns. Store and forward, by passes of one place: a fragment is five words, row, column and a pixel; the lane of its column keeps the nearest in
; its frame buffer. Two pixels compare as numbers of 48 bits, so the order in which they come makes no difference.
;
; The rasteriser has listed the pixels drawn; when one is taken out its depth becomes 0 again, ready for the next band. One for the lane's own column
; goes all the way round.
; Needs columns numbered as lanes and not fewer lanes than columns: otherwise error 3 and halt. Passes are counted in pixel_passes.
; Memory: fragment_next. Counter: c3 passes of a scanline.

most_lanes = 65536
fragment_next = other_scratch+64        ; place in the list of the next own fragment
fragment_slot = other_scratch+65        ; r1 ... r5 from scanline to scanline

row     = r1                            ; the fragment in the lane's slot
column_of = r2                          ; -1: none
word0   = r3
word1   = r4
word2   = r5
next    = r6
next_end = r7
here    = r8
buffer  = r9
next_at = r10                           ; the next own fragment: address, row, column, pixel
next_row = r11
next_column = r12
next0   = r13
next1   = r14
next2   = r15

kSendCycles = 38                        ; of a pass, at most

        .macro  fragment_words op
at = fragment_slot
        .irp    reg, <row, column_of, word0, word1, word2>
        op      reg, at
at = at+1
        .endr
        .endm

        .macro  look_ahead
        lds     next_at, 0, (next)
        lds     next0, 1, (next_at)
        lds     next1, 2, (next_at)
        lds     next2, 3, (next_at)
        place   next_column, next_row, next_at, r16, r17
        .endm

; An empty slot takes the next own fragment.
        .macro  take_fragment
        tlt     column_of, r0
        tltu.and next, next_end
        slf
        sts     r0, 1, (next_at)
        add     next, next, #1
        mov     row, next_row
        mul     column_of, next_column, #1
        mov     word0, next0
        mul     word1, next1, #1
        mov     word2, next2
        wake
        .endm

        .macro  pass_fragment
        .irp    part, <row, column_of, word2, word1, word0>
        put     part
        right   1
        get     part
        .endr
        .endm

; Where the slot's fragment has come to its column it is kept if it is nearer; the slot is empty.
        .macro  keep_nearer
        mul     r18, row, #kPixel
        add     r18, r18, buffer
        ld      r19, 0(r18)
        ld      r20, 1(r18)
        ld      r21, 2(r18)
        teq     column_of, here
        tget    r22
        sub     r22, r0, r22
        or      column_of, column_of, r22
        subs    r0, r21, word2
        sbc     r0, r20, word1
        sbc     r0, r19, word0
        tltb.and r0, r0
        slf
        st      word0, 0(r18)
        st      word1, 1(r18)
        st      word2, 2(r18)
        wake
        .endm

composite:
        wake
        phase   5
        ld      r16, lanes
        sub     r16, r16, #1
        tltu    r16, #screen_columns-1
        bt      lanes_left_over
        mov     next, #kGathered
        mov     column_of, #-1
        st      next, fragment_next
        fragment_words st
        setp    send
        line

send:
        wake
        fragment_words ld
        ld      next, fragment_next
        ld      next_end, fragments_end
        ld      here, column
        ld      buffer, drawing
        mov     r23, r0                 ; passes, two words
        mov     r28, r0
        .if ne line_locked
        setc    c3, kPassCycles-60/kSendCycles
        .endc
        look_ahead
        take_fragment
send_loop:
        tge     column_of, r0
        bnor    send_done
        pass_fragment
        adds    r23, r23, #1
        adc     r28, r28, r0
        look_ahead
        keep_nearer
        take_fragment
        .if ne line_locked
        dec     c3, send_loop
        jump    send_save
        .else
        jump    send_loop
        .endc
send_done:
        next_band
send_save:
        fragment_words st
        st      next, fragment_next
        ld      r24, pixel_passes
        ld      r25, pixel_passes+1
        adds    r24, r24, r23
        adc     r25, r25, r28
        st      r24, pixel_passes
        st      r25, pixel_passes+1
        line
