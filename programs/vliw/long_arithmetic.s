; SPDX-License-Identifier: MIT
; Multiplication and division of signed 32-bit numbers, as a compiler would call them: what they cost is to be compared with Eldridge
; 1995, 2.1 (100 instructions, over 400). The renderers do not use them. Numbers lie in two registers, the lower word first. No lane
; sleeps or wakes here; C is changed.

        .include "arithmetic.s"

; r5:r6 := r1:r2 * r3:r4, modulo 2^32. Spoils r7, r8.
multiply32:
        mulu    r5, r1, r3, 0
        mulu    r6, r1, r3, 16
        mul     r7, r1, r4, 0
        mul     r8, r2, r3, 0
        add     r6, r6, r7
        add     r6, r6, r8
        ret

; r5:r6 := r1:r2 / r3:r4, towards zero; r7:r8 := the remainder, with the dividend's sign. A division by zero gives -1 (1 for a negative
; dividend), remainder the dividend; -2^31 / -1 gives -2^31. Spoils r9 ... r15 and counter c7.
divide32:
        abs32   r5, r6, r1, r2, r9
        abs32   r10, r11, r3, r4, r12
        xor     r12, r12, r9
        mov     r7, r0
        mov     r8, r0
        setc    c7, 32
1$:     add32   r5, r6, r5, r6, r5, r6  ; the dividend's bits leave above, the quotient's, inverted, enter below
        adc     r7, r7, r7
        adc     r8, r8, r8
        sub32   r13, r14, r7, r8, r10, r11
        sbc     r15, r0, r0             ; -1 where the divisor does not go
        sub     r5, r5, r15
        and     r7, r10, r15
        and     r8, r11, r15
        add32   r7, r8, r13, r14, r7, r8
        dec     c7, 1$
        xor     r5, r5, #-1
        xor     r6, r6, #-1
        sign32  r5, r6, r12
        sign32  r7, r8, r9
        ret
