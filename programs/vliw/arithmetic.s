; SPDX-License-Identifier: MIT
; Arithmetic of more than 16 bits, divisions and roots by table: macros, so that the scheduler packs them among their neighbours.
;
; Parameters are registers unless said otherwise; those that are written come first. 32-bit numbers are two registers, the lower word
; first. All macros work on awake lanes, none sleeps or wakes any. T and C are left changed where the text says so.
; Written registers may be read ones, too, word for word (`add32 r1, r2, r1, r2, r3, r4`), where no other order is named.

; d := a + b; a - b. Change C.
        .macro  add32 dl, dh, al, ah, bl, bh
        adds    dl, al, bl
        adc     dh, ah, bh
        .endm

        .macro  sub32 dl, dh, al, ah, bl, bh
        subs    dl, al, bl
        sbc     dh, ah, bh
        .endm

; T := a < b, signed; mode: nothing, .and, .or. Changes C; t: spoilt.
        .macro  less32 al, ah, bl, bh, t, mode
        subs    t, al, bl
        tltb'mode ah, bh
        .endm

; d := |a|; sign := -1 where a was negative, else 0. Changes C. sign is none of the others.
        .macro  abs32 dl, dh, al, ah, sign
        asr     sign, ah, #15
        xor     dl, al, sign
        xor     dh, ah, sign
        sub32   dl, dh, dl, dh, sign, sign
        .endm

; d := d, negated where sign is -1. Changes C.
        .macro  sign32 dl, dh, sign
        xor     dl, dl, sign
        xor     dh, dh, sign
        sub32   dl, dh, dl, dh, sign, sign
        .endm

; d := a * b in 32 bits. d is neither a nor b.
        .macro  product dl, dh, a, b
        mul     dl, a, b, 0
        mul     dh, a, b, 16
        .endm

; The same for a signed a and an unsigned b.
        .macro  productsu dl, dh, a, b
        mulsu   dl, a, b, 0
        mulsu   dh, a, b, 16
        .endm

; d := d + a * b, 32 bits. Changes C; tl, th: spoilt.
        .macro  add_product dl, dh, a, b, tl, th
        product tl, th, a, b
        add32   dl, dh, dl, dh, tl, th
        .endm

        .macro  sub_product dl, dh, a, b, tl, th
        product tl, th, a, b
        sub32   dl, dh, dl, dh, tl, th
        .endm

; d2:d1:d0 := a * b, a 32 bits signed, b 16 bits unsigned. Changes C; t: spoilt. d is neither a nor b.
        .macro  product48 d0, d1, d2, al, ah, b, t
        mulu    d0, al, b, 0
        mulu    d1, al, b, 16
        productsu t, d2, ah, b
        adds    d1, d1, t
        adc     d2, d2, r0
        .endm

; sum := a b + c d + e f, signed 16-bit factors, 32 bits. Changes C; t's: spoilt. sum and t's are none of the factors.
        .macro  three_products suml, sumh, a, b, c, d, e, f, t1, t2, t3, t4
        product suml, sumh, a, b
        product t1, t2, c, d
        product t3, t4, e, f
        add32   suml, sumh, suml, sumh, t1, t2
        add32   suml, sumh, suml, sumh, t3, t4
        .endm

; Inner product of two vectors of s1.14, each product rounded down. t's: spoilt. d and t's are none of the others.
        .macro  inner d, a, b, c, e, f, g, t1, t2
        mul     d, a, b, 14
        mul     t1, c, e, 14
        mul     t2, f, g, 14
        add     d, d, t1
        add     d, d, t2
        .endm

; d := the greater of a and 0. d may be a; mask: spoilt.
        .macro  positive d, a, mask
        mul     mask, a, #1, 15
        andn    d, a, mask
        .endm

; d := the lesser of a and the number n; a - n must fit a word. d may be a; t: spoilt.
        .macro  at_most d, a, n, t
        sub     d, a, #n
        mul     t, d, #1, 15
        and     d, d, t
        add     d, d, #n
        .endm

; low, high := the least and the greatest of a, b, c, whose differences fit a word; first := a - b. t's: spoilt; none is another.
        .macro  span16 low, high, first, a, b, c, t1, t2
        sub     first, a, b
        mul     t1, first, #1, 15
        and     t1, first, t1
        add     low, b, t1
        sub     high, a, t1
        sub     t1, low, c
        mul     t2, t1, #1, 15
        and     t1, t1, t2
        add     low, c, t1
        sub     t1, c, high
        mul     t2, t1, #1, 15
        andn    t1, t1, t2
        add     high, high, t1
        .endm

; Normalisation goes in binary steps, on all lanes alike: T, fetched as a number, is the shift.
;
; Where h:l < limit (a number up to 0x8000): h:l := l:0. e := 16 there, else 0. Changes T; t: spoilt.
        .macro  word_step h, l, e, limit, t
        tltu    l, #limit
        teq.and h, r0
        tget    e
        sub     t, r0, e
        and     t, l, t
        or      h, h, t
        sub     l, l, t
        mul     e, e, #16
        .endm

; Where w < limit: w := w << n. e := n there, else 0. Changes T.
        .macro  first_step w, e, limit, n
        tltu    w, #limit
        tget    e
        mul     e, e, #n
        shl     w, w, e
        .endm

; The same, but the places are added to e. Changes T; t: spoilt.
        .macro  next_step w, e, limit, n, t
        first_step w, t, limit, n
        add     e, e, t
        .endm

; Normalises h:l, 1 ... 2^30 - 1: h:l := h:l << e, so that 2^30 <= h:l < 2^31. Changes T; w, n, t: spoilt.
        .macro  normalise h, l, e, w, n, t
        word_step h, l, e, 0x8000, t
        mov     w, h                    ; the lower word cannot change what the steps find
        first_step w, n, 0x80, 8
        next_step w, n, 0x800, 4, t
        next_step w, n, 0x2000, 2, t
        next_step w, n, 0x4000, 1, t
        add     e, e, n
        shl     h, h, n
        sub     t, r0, n                ; 16 - n as shifts read it; the lower word is 0 where n is
        shr     t, l, t
        or      h, h, t
        shl     l, l, n
        .endm

; d := 2^46 / h:l, rounded down, at most 1 less; h:l normalised (2^30 ... 2^31 - 1). From the table comes 2^44 / h:l in 14 bits; what its
; product misses of 2^44 mends the rest. w, t: spoilt; d is none of the others.
        .macro  reciprocal d, h, l, w, t
        ld      w, reciprocals(h)
        mul     d, w, h, 0
        mulu    t, w, l, 16
        add     d, d, t
        xor     d, d, #-1               ; (2^44 - w h:l) / 2^16
        mul     d, d, w, 26
        mul     w, w, #4
        add     d, d, w
        .endm

; For a vector of three words, each less than 2^14 in size: turns it into the unit vector, s1.14; the zero vector stays.
; Changes C and T; the others: spoilt.
        .macro  unit_vector x, y, z, l, h, e, n, w, t1, t2
        three_products l, h, x, x, y, y, z, z, t1, t2, w, n
        word_step h, l, e, 0x4000, t1
        mov     w, h
        first_step w, n, 0x40, 8
        next_step w, n, 0x400, 4, t1
        next_step w, n, 0x1000, 2, t1
        add     t1, n, #2               ; 2^28 <= h:l << n < 2^30; where h is 0 this may be 16, read as 0
        shl     h, h, t1
        sub     t1, r0, t1
        shr     l, l, t1
        or      h, h, l                 ; bits 14 ... 29
        mulu    w, h, #1, 7
        ld      w, roots-128(w)         ; 2^21 / sqrt(h) from 9 of its bits; then Newton's step:
        mulu    t1, w, w, 13            ; 2^29 / h
        mulu    t1, t1, h, 16           ; 2^13
        mov     t2, #0x6000
        sub     t1, t2, t1
        mul     w, w, t1, 14
        add     e, e, n
        mul     e, e, #1, 1
        shl     x, x, e
        shl     y, y, e
        shl     z, z, e
        mul     x, x, w, 14
        mul     y, y, w, 14
        mul     z, z, w, 14
        .endm
