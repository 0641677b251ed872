; SPDX-License-Identifier: MIT
; Bundle 0: what every scanline begins with (Eldridge 1995, 2.3, 7.2, 7.6). Then the procedure that the pointer names is called; a procedure ends
; with `line`. At the very first, at `start`, the pointer is set.
;
; Line-locked, a scanline first
; - sends the pixel of its row of the buffer being shown to the video register: 5 bits red, 6 green, 5 blue; 0 below the last row (video 0: nothing);
; - takes one integer from the auxiliary input. The matrix comes by it: on scanline 0 of a frame 0x8000 or 0x8001 (the host may put the frame's
;   parity there), on the next twelve scanlines the words m0 ... m11. Nothing to say: 0, or anything but a marker. Behind a marker twelve words are
;   taken for what they are, whatever they look like. The marker also sets the row that is shown right, should the machine and the program
;   have come apart. A matrix that has come entirely is taken over before the next picture's geometry (finish.s).
;
; Registers: r1 ... r12. Memory: matrix_*, scanline, unshown.

matrix_due      = other_scratch+32      ; words of the matrix still to come
matrix_complete = other_scratch+33      ; 1: all have come
matrix_shadow   = other_scratch+34      ; 12 words
unshown         = other_scratch+46      ; 1: the picture finished last is not yet being shown
kMatrix         = 12
kRows           = screen_rows

dispatch:
        .if ne line_locked
        wake
        aux     r1
        ld      r2, matrix_due
        ld      r3, scanline
        tne     r2, r0
        bt      dispatch_word
        andn    r4, r1, #1
        teq     r4, #0x8000
        bf      dispatch_row
        mov     r2, #kMatrix
        mov     r3, r0
        st      r2, matrix_due
        st      r0, matrix_complete
        jump    dispatch_row
dispatch_word:
        sub     r4, r0, r2
        st      r1, matrix_shadow+kMatrix(r4)
        sub     r2, r2, #1
        st      r2, matrix_due
        teq     r2, r0
        tget    r5
        st      r5, matrix_complete
dispatch_row:
        tltu    r3, #kRows
        tget    r11
        ld      r12, unshown
        andn    r12, r12, r11
        st      r12, unshown
        .if ne video
        ld      r4, shown
        mul     r5, r3, #kPixel
        add     r4, r4, r5
        ld      r6, 1(r4)
        ld      r7, 2(r4)
        and     r8, r6, #0x00f8
        shl     r8, r8, #8
        and     r9, r7, #0xfc00
        shr     r9, r9, #5
        and     r10, r7, #0x00f8
        shr     r10, r10, #3
        or      r8, r8, r9
        or      r8, r8, r10
        mul     r8, r8, r11
        vout    r8
        .endc
        add     r3, r3, #1
        tltu    r3, #scanlines
        tget    r12
        mul     r3, r3, r12
        st      r3, scanline
        .endc
        callp
