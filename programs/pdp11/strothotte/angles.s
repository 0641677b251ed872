; SPDX-License-Identifier: MIT
; Sine and cosine by linear interpolation in a quarter wave of 257 words (sine.s), right to 1/16384. The thesis (5.1.4)
; interpolates in a table near the poles of rotation only and uses derivatives elsewhere; here one way serves everywhere.

; In: r0 angle. Out: sine and cosine (memory), s1.14. Clobbers r0 to r3.
sin_cos:
        mov     r0, angle
        call    sin14
        mov     r0, sine
        mov     angle, r0
        add     #40000, r0
        call    sin14
        mov     r0, cosine
        return

; In: r0 angle. Out: r0 its sine. Clobbers r1, r2, r3.
sin14:  mov     r0, r1
        bic     #140000, r1             ; its place in its quarter
        bit     #40000, r0
        beq     1$
        neg     r1                      ; odd quarters run backwards
        add     #40000, r1
1$:     mov     r1, r2
        bic     #177700, r2             ; 64ths of a step
        ash     #-5, r1
        bic     #1, r1                  ; offset of the step's entry
        mov     quarter_wave+2(r1), r3
        sub     quarter_wave(r1), r3
        mul     r2, r3
        add     #32., r3
        ash     #-6, r3
        add     quarter_wave(r1), r3
        tst     r0
        bpl     2$
        neg     r3
2$:     mov     r3, r0
        return
