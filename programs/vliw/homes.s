; SPDX-License-Identifier: MIT
; Sort-first (Eldridge 1995, 3.2.1, 4.3.2, 5.5): a lane is the home of some of the polygons, and does their first geometry, which tells what columns
; they cover: `sort_homes`. Then they migrate to where they are (migrate.s), and copies go to all lanes that draw them (distribute.s), which do
; the whole of the geometry, each for itself.
;
; A home is kHome words of the room from polygons_at to homes_end: the polygon, its columns, and the communication's word. Their addresses stand in
; slow bank 0, from `homes` on: first of those that are somebody's home, up to home_end, then, from home_free on, of those that are free. The last
; is never anybody's home: it is where a polygon is that only passes through. The host's list is in order; it says how many in `polygons`.
; A database with more polygons than homes: error 5 and halt.
;
; Memory: home_*; counter: c2 (list_some).

        .include "pass.s"

        .if ne duplication-1!<stride-1>
        .error  sort-first knows neither duplication nor strides
        .endc
        .if gt migrate-2
        .error  migrate must be 0, 1 or 2
        .endc

h_left      = 24        ; columns, within the screen and the ring
h_right     = 25        ; less than h_left: nowhere to be seen
h_passes    = 26        ; passes to go

homes       = 0xc000
movers      = 0xd000    ; those that are to be sent from here

home_end    = other_scratch+50
home_free   = other_scratch+51
home_last   = other_scratch+52          ; the last of all

sent_end    = r28                       ; link_end, while movers are listed

kListed         = 100                   ; homes listed on a scanline
kWalked         = 20                    ; homes visited on a scanline
kColumnsALine   = 4                     ; polygons looked at on a scanline

; d := the lesser of d and n, whose difference fits a word. t, u: spoilt.
        .macro  lesser d, n, t, u
        sub     t, d, n
        mul     u, t, #1, 15
        and     t, t, u
        add     d, n, t
        .endm

start_homes:
        setp    list_homes
        line

list_homes:
        wake
        ld      r1, polygons_at
        ld      r2, polygons
        mov     r3, #homes-1
        add     r4, r2, #homes
        st      r1, next_polygon
        st      r3, home_last
        st      r4, home_end
        st      r4, home_free
        st      r2, most_homes
        setp    list_some
        line

list_some:
        wake
        setc    c2, kListed
        ld      r1, next_polygon
        ld      r2, home_last
        ld      r3, homes_end
        sub     r3, r3, #kHome
        tgeu    r3, r1
list_loop:
        slf
        add     r2, r2, #1
        sts     r1, 0, (r2)
        add     r1, r1, #kHome
        tgeu    r3, r1
        bnor    list_done
        dec     c2, list_loop
        jump    list_save
list_done:
        wake
        ld      r4, home_end
        tltu    r2, r4
        bor     no_home
        setp    begin
list_save:
        wake
        st      r1, next_polygon
        st      r2, home_last
        line

no_home:
        slf
        mov     r1, #5
        st      r1, error
        halt

sort_homes:
        wake
        copy_matrix
        mov     r1, #homes
        ld      r2, home_end
        st      r1, next_polygon
        st      r2, polygons_stop
        setp    find_columns
        line

; The columns of every home's polygon. Registers as in transform.
find_columns:
        wake
        setc    c1, kColumnsALine
        load_view
        mov     r29, #spare_slot
1$:     take_polygon
        transform_polygon
        tget    r1
        ld      r2, lanes
        sub     r2, r2, #1
        positive r11, r11, r3
        at_most r12, r12, screen_columns-1, r4
        lesser  r12, r2, r5, r6
        sub     r1, r1, #1
        or      r12, r12, r1
        st      r11, h_left(r28)
        st      r12, h_right(r28)
        if_more 2$
        .if ne migrate
        setp    migrate_right
        .else
        setp    distribute
        .endc
        line
2$:     dec     c1, 1$
        line

; ---- Passes of homes: the columns and how far to go first, so that they can be looked at, then the polygon.
        .macro  take_h
        lds     slot, 0, (own)
        ld      to_go, h_passes(slot)
        add     own, own, #1
        .endm

        .macro  pass_h  places, way=right
        ld      r17, h_left(slot)
        pass_word h_left, first, h_right, places, way
        pass_word h_right, last, 0, places, way
        put     handed
        way     places
        get     to_go
        st      to_go, h_passes(into)
at = 0
        .rept   kPolygon-1
        pass_word at, r21, at+1, places, way
at = at+1
        .endr
        put     r17
        way     places
        get     r21
        st      r21, at(into)
        .endm

; ---- A walk over all homes, from link_next to home_free: begin_walk, name_loop:, look_home, what is to be done, end_walk.
        .macro  begin_walk
        wake
        ld      own, link_next
        ld      own_end, home_free
        ld      here, lane
        ld      ring, lanes
        ld      sent_end, link_end
        setc    c2, kWalked
        tltu    own, own_end
        .endm

        .macro  look_home
        slf
        lds     slot, 0, (own)
        ld      first, h_left(slot)
        ld      last, h_right(slot)
        .endm

; The home is listed among those that are sent if `so` is 1, d passes far.
        .macro  send_home d, so
        st      d, h_passes(slot)
        sts     slot, 0, (sent_end)
        add     sent_end, sent_end, so
        .endm

; reg, memory: what else is kept from scanline to scanline.
        .macro  save_walk reg, memory
        st      reg, memory
        st      sent_end, link_end
        .endm
        .macro  end_walk name, next, reg, memory
        add     own, own, #1
        next_preparation name, next, <save_walk reg, memory>
        .endm

; d := (to - here) modulo the ring; t: spoilt.
        .macro  distance d, to, t
        sub     d, to, here
        mul     t, d, #1, 15
        and     t, t, ring
        add     d, d, t
        .endm
