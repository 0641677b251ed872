; SPDX-License-Identifier: MIT
; Slopes: a difference divided by a number of steps, cut towards zero.
;
; thesis precision: q = d / n. One division.
; full precision:   q = d * 2^15 / n, as its whole part I = d / n (cut towards zero) and a signed fraction of 15 bits F =
;                   (d - I n) * 2^15 / n: a division each, since DIV takes 32 bits and gives 16. q / 2^15 with 16 bits of
;                   fraction is then I * 2^16 + 2 F.

; In: d in r1, the condition codes of its computing; n > 0 in register n, which is not r0, r1 or whole.
; Out: full: I in register whole, F in r0. thesis: q in r0. Clobbers r1.
        .macro  divide n, whole, ?nonzero, ?divided
        .if ne skip_deltas
        bne     nonzero
        clr     r0
        .if ne full
        clr     whole
        .endc
        br      divided
nonzero:
        .endc
        sxt     r0
        div     n, r0
        .if ne full
        mov     r0, whole
        mov     r1, r0                  ; the remainder times 2^15
        clr     r1
        asr     r0
        ror     r1
        div     n, r0
        .endc
divided:
        .endm

        .if ne full

; The value at the vertex at r5, pushed before sp with a half for rounding.
        .macro  push_start at
        mov     #100000, -(sp)
        mov     at(r5), -(sp)
        .endm

        .endc

; 32-bit I * 2^16 + 2 F from I and F, in place.
        .macro  join_slope whole, fraction
        asl     fraction
        sbc     whole
        .endm

; The reverse: the low word of a 32-bit slope becomes an F that is not negative; the high word is the I that goes with it.
        .macro  split_slope low
        clc
        ror     low
        .endm

; The slope from step to step of a grid from the slope from one pixel or line to the next, in place: 32 bits in r0:r1, or in
; thesis precision r0 (r1 is spent then). Clobbers r3.
        .macro  scale_slope step, shift, ?by_product, ?scaled
        mov     shift, r3
        bmi     by_product
        .if ne full
        ashc    r3, r0
        .iff
        ash     r3, r0
        .endc
        br      scaled
by_product:
        .if ne full
        mov     r0, r3
        mul     step, r3                ; an odd register: the product's low word
        split_slope r1
        mov     r1, r0
        mul     step, r0
        asl     r1
        rol     r0
        add     r3, r0
        .iff
        mov     r0, r1
        mul     step, r1
        mov     r1, r0
        .endc
scaled:
        .endm

; The value so many steps after `from`. full: in: I in r3, F in r0; out: 32 bits in r0:r1, a half added for rounding. thesis: in: q
; in r0, out: r1, which leaves r0 as it was. Clobbers r3.
        .macro  value_after steps, from
        .if ne full
        mul     steps, r3
        mul     steps, r0
        asl     r1
        rol     r0
        add     #100000, r1
        adc     r0
        add     r3, r0
        add     from, r0
        .iff
        mov     r0, r1
        mul     steps, r1
        add     from, r1
        .endc
        .endm
