; SPDX-License-Identifier: MIT
; Arithmetic on 16-bit fixed point. s1.14 holds -2 to 2 in steps of 1/16384.

        .macro  call where
        jsr     pc, where
        .endm

        .macro  return
        rts     pc
        .endm

; What the statistics book the time to from here on.
        .macro  doing what
        mov     #what, @#io_mark
        .endm

; high = the product in high and low times 4, rounded: the s1.14 of a product or sum of products of s1.14.
        .macro  to14 high, low
        ashc    #2, high
        rol     low
        adc     high
        .endm

; high = high * factor, all s1.14. `high` is an even register, `low` the next one, which is spent.
        .macro  fmul factor, high, low
        mul     factor, high
        to14    high, low
        .endm

; r0:r1 = r0:r1 + r2:r3
        .macro  add32
        add     r3, r1
        adc     r0
        add     r2, r0
        .endm
