; SPDX-License-Identifier: MIT
; From one picture to the next: buffers exchanged, the new one cleared, the matrix taken over. Line-locked this waits for the rows
; that are not visible, and for the picture before to have been shown: a small one may be done before it is.
; After `frame` the word `shown` is the address of the picture just finished.
; Without video there are no buffers, nothing to be exchanged or cleared.
; Memory: clear_at. Counter: c4.

clear_at    = other_scratch+48          ; first word that is still to be cleared
kFrame      = kRows*kPixel
kCleared    = 96                        ; words at once
        .if ne video
        .if ne screen_rows&63
        .error  screen_rows must be a multiple of 64 where there are frame buffers
        .endc
        .endc

        .macro  begin_geometry
        phase   1
        .if ne sort_first
        setp    sort_homes
        .else
        setp    geometry
        .endc
        .endm

        .macro  take_matrix
        ld      r4, matrix_complete
        tne     r4, r0
        slf
at = 0
        .rept   kMatrix/2
        ld      r5, matrix_shadow+at
        ld      r6, matrix_shadow+at+1
        st      r5, matrix+at
        st      r6, matrix+at+1
at = at+2
        .endr
        st      r0, matrix_complete
        wake
        .endm

start:
        setp    begin
        line

begin:
        wake
        .if ne video
        mov     r1, #frame_buffers
        mov     r2, #frame_buffers+kFrame
        st      r1, drawing
        st      r2, shown
        st      r1, clear_at
        setp    clear
        .else
        begin_geometry
        .endc
        line

finish:
        wake
        phase   0
        .if ne line_locked
        ld      r1, scanline            ; the next one
        ld      r2, unshown
        tltu    r1, #kRows+1
        tne.or  r2, r0
        bt      finish_wait
        mov     r3, #1
        st      r3, unshown
        .endc
        .if ne video
        ld      r2, drawing
        ld      r3, shown
        st      r2, shown
        st      r3, drawing
        st      r3, clear_at
        .endc
        frame
        .if ne line_locked
        take_matrix
        .endc
        .if ne video
        setp    clear
        .else
        begin_geometry
        .endc
finish_wait:
        line

        .if ne video
clear:
        wake
        ld      r1, clear_at
        setc    c4, kFrame/<2*kCleared>
clear_loop:
at = 0
        .rept   kCleared
        st      r0, at(r1)
at = at+1
        .endr
        add     r1, r1, #kCleared
        dec     c4, clear_loop
        st      r1, clear_at
        ld      r2, drawing
        add     r2, r2, #kFrame
        tlt     r1, r2
        bt      clear_save
        begin_geometry
clear_save:
        line
        .endc
