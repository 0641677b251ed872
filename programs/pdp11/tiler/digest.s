; SPDX-License-Identifier: MIT
; Half-digested broadcast, a processor's share: polygons that come at port 0 reach this processor alone. It works out their
; sides and sends them by port 1 to the turn bus, which hands them to all processors of the group (this one, too) at port 1, in
; the order of the polygons (machine/fabric/turn_bus.hpp). A digested polygon is the message
;
;     byte 0   kind: 3
;     byte 1   hops
;     word 1   number of vertices
;     word 2   byte offset of the right side's first record
;     word 3   the lowest row
;     word 4   in full precision, the highest row: on it is a vertex, or a part begins there
;     records of the left side, then of the right side, each from its topmost vertex down:
;       x, y, z, shade of the vertex, then the slopes of x, z and shade down the edge below it, two words each (high one
;       first, 16 bits of fraction) or, in thesis precision, one. The first vertex on the lowest row or below it ends its side
;       and has no slopes.

; The next digested polygon. On the way there, raw polygons are digested as long as one waits and the output has room: then
; nobody needs to wait for them. When the output is full only digested polygons are taken: one must come, since the bus will
; take what this processor has sent and hand it back.
tap_idle:
next_polygon:
        mov     #wait_message, @#io_waitfor
choose_message:
        bit     #rx_waits_bit, @#ports_base+rxstat
        beq     take_digested
        bit     #digest_room, @#io_txroom
        bne     take_raw
take_digested:
        mov     #message, @#digest_port+rxaddr
        tst     vertex_count
        beq     end_of_frame
        jmp     begin_polygon

; The end of the frame goes to the bus like a polygon: when it has come from all, all get it back.
forward_end:
        mov     #message, @#digest_port+txaddr
        mov     #4, @#digest_port+txlen
        mov     #wait_message, @#io_waitfor
        br      choose_message

take_raw:
        mov     #message, @#ports_base+rxaddr
        mov     vertex_count, r1
        beq     forward_end
        .if ne full
        bpl     digest_whole
        neg     r1
        mov     r1, vertex_count
tap_digest_part:
        .include "scan.s"
        part_rows r3, r4
        br      digest_rows
        .endc

digest_whole:
tap_digest:
        .include "scan.s"

digest_rows:
        .if ne full
        mov     r3, digest_highest
        .endc
        mov     vertex_count, digest_vertices
        mov     r4, digest_lowest
        mov     sp, digest_top
        mov     #digest_left, sp
        digest_side left
        mov     sp, r0
        sub     #digest, r0
        mov     r0, digest_right
        mov     digest_top, r5
        digest_side right
        sub     #digest, sp
        mov     #digest, @#digest_port+txaddr
        mov     sp, @#digest_port+txlen
tap_idle_digested:
        mov     #wait_message, @#io_waitfor
        jmp     choose_message
