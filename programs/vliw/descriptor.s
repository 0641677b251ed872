; SPDX-License-Identifier: MIT
; What is made of a descriptor's words: its linear equations at a place, C + A x + B y, modulo 2^32, and its colours. x and y: whole, -1 and
; more. `d` is the register that points to the descriptor. Nobody sleeps; C is changed.

; hi:lo += a by, with a a word; p and q to work with.
        .macro  add_product hi, lo, a, by, p, q
        mul     p, a, by
        mul     q, a, by, 16
        adds    lo, lo, p
        adc     hi, hi, q
        .endm

; hi:lo += ah:al by
        .macro  add_long_product hi, lo, ah, al, by, p, q
        mul     p, al, by
        mulsu   q, by, al, 16
        mul     ah, ah, by
        add     q, q, ah
        adds    lo, lo, p
        adc     hi, hi, q
        .endm

; The edge at `at`: hi:lo, and its A and B.
        .macro  edge_value d, at, x, y, hi, lo, a, b, p, q
        ld      a, at(d)
        ld      b, at+1(d)
        ld      lo, at+2(d)
        ld      hi, at+3(d)
        add_product hi, lo, a, x, p, q
        add_product hi, lo, b, y, p, q
        .endm

; A parameter of two-word coefficients. bias: whole units to be added.
        .macro  long_value d, at, x, y, bias, hi, lo, ah, al, bh, bl, p, q
        ld      al, at(d)
        ld      ah, at+1(d)
        ld      bl, at+2(d)
        ld      bh, at+3(d)
        ld      lo, at+4(d)
        ld      hi, at+5(d)
        add_long_product hi, lo, ah, al, x, p, q
        add_long_product hi, lo, bh, bl, y, p, q
        .if ne bias
        add     hi, hi, #bias
        .endc
        .endm

; The intensity as the rasteriser wants it, 64 times (the intensity less 255), without the half unit: hi:lo. b: its B. vh and vl are spoilt.
        .macro  intensity_value d, x, y, hi, lo, a, b, vh, vl, p, q
        ld      a, d_intensity(d)
        ld      b, d_intensity+1(d)
        ld      vl, d_intensity+2(d)
        ld      vh, d_intensity+3(d)
        mul     p, a, x
        mul     q, a, x, 8
        shl     p, p, #8
        adds    vl, vl, p
        adc     vh, vh, q
        mul     p, b, y
        mul     q, b, y, 8
        shl     p, p, #8
        adds    vl, vl, p
        adc     vh, vh, q
        subs    vl, vl, #0x8000
        sbc     vh, vh, #255
        shl     hi, vh, #6
        shr     q, vl, #10
        or      hi, hi, q
        shl     lo, vl, #6
        .endm

; Colours to 16 bits, texture to one word, in place. red ... t: to work with.
        .macro  normalise_colours d, rg, bt, red, green, blue, t
        ld      rg, d_colour(d)
        ld      bt, d_colour+1(d)
        shr     red, rg, #8
        mulu    red, red, #257
        and     green, rg, #0xff
        mulu    green, green, #257
        shr     blue, bt, #8
        mulu    blue, blue, #257
        .if ne textured
        ld      t, d_colour+2(d)
        and     bt, bt, #0xff
        or      bt, bt, t
        .endc
        st      red, n_red(d)
        st      green, n_green(d)
        st      blue, n_blue(d)
        .if ne textured
        st      bt, n_texture(d)
        .endc
        .endm
