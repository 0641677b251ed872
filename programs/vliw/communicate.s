; SPDX-License-Identifier: MIT
; Sort-middle communication on columns: every descriptor comes to each lane whose column it covers, once (Eldridge 1995, 5.1 to 5.3, 7.4, A.2.2).
;
; stride 1: one round, by passes of 1. A descriptor that its own lane wants goes all the way round, so none is ever copied. Received is behind the
;   last descriptor to be sent: so it makes no difference how many a lane sends, as long as both fit.
; stride d: two rounds. The far one, by passes of d, brings a descriptor from lane s to each lane t = s + k d, k = 1 ... lanes / d - 1, with a
;   destination in its window, the d lanes behind t. From there, and from s to the window of s, it is sent on in the near round, by at most d
;   passes of 1: windows do not overlap, so nobody gets it twice.
;   The lane's own and, behind them, what the far round brings fill the room from its beginning. The near round sends the last of them first and
;   receives from the room's end down, into what it has sent already, too.
; dense 1: a descriptor goes no further than it must; 0: all the way, which is lanes / d passes, or d in the near round of two.
;
; Needs: columns numbered as lanes; lanes a multiple of stride, at most most_lanes; room from source_at to receive_end for one descriptor more than
; lie there at a time. Error 2 and halt: a lane keeps more.
; Memory, counter: see pass.s.

reach = 1
log2_stride = 0
kListings = 20          ; descriptors prepared on a scanline by strides
        .rept   9
        .if lt reach-stride
reach = reach*2
log2_stride = log2_stride+1
        .endc
        .endr
        .if ne reach-stride
        .error  stride must be a power of two, 1 to 512
        .endc

most_lanes = 32767*stride       ; passes to go are signed words
        .if gt most_lanes-65536
most_lanes = 65536
        .endc

brink   = r7            ; the last lane of the window, the lanes behind this one that it sends to in the near round, modulo 2^16
seam    = r8            ; the same less lanes, where the window goes over the end of the ring; otherwise -1

        .include "pass.s"
        .include "wanted.s"

list_top = wanted+1024  ; the addresses of what the lane sends stand from link_own to here

communicate:
        wake
        phase   2
        st      r0, far_passes
        st      r0, far_passes+1
        st      r0, near_passes
        st      r0, near_passes+1
        ld      own, source_at
        ld      own_end, source_count
        mul     own_end, own_end, #kDescriptor
        add     own_end, own_end, own
        st      own_end, received_at
        .if gt stride-1
        begin_round received_at, receive_end, prepare_far, sent=#list_top
        .else
        begin_round received_at, receive_end, prepare_near
        .endc

        .if gt stride-1
communicate_near:
        wake
        ld      own, source_at
        ld      own_end, link_into
        ld      into, receive_end
        sub     into, into, #kDescriptor
        mov     room, own_end
        start_round prepare_near, sent=#list_top
        .endc

        .macro  find_window window
        ld      here, lane
        ld      ring, lanes
        add     brink, here, window
        sub     r16, ring, window
        tgeu    here, r16
        tget    r17
        sub     seam, here, r16
        add     seam, seam, #1
        mul     seam, seam, r17
        sub     seam, seam, #1
        .endm

; T := a column lies in the window.
        .macro  in_window
        tltu    here, last
        tgeu.and brink, first
        tge.or  seam, first
        .endm

; ---- Preparation: d_passes of what the lane sends.
        .macro  begin_preparation window, count=kPreparations
        wake
        ld      own, link_next
        ld      own_end, link_end
        find_window window
        setc    c2, count
        tltu    own, own_end
        .endm

; The box; a screen that is wider than the ring ends with the ring.
        .macro  load_box
        ld      first, d_left(own)
        ld      last, d_right(own)
        ld      r17, d_top(own)
        ld      r18, d_bottom(own)
        sub     r20, ring, #1
        tltu    r20, last
        tge.and last, r0
        tget    r21
        sub     r22, r20, last
        mul     r22, r22, r21
        add     last, last, r22
        st      last, d_right(own)
        .endm

        .if gt stride-1
; r16 is the number of passes; what has some is listed.
        .macro  finish_listing name, next
        may_be_seen r19
        mul     r16, r16, r19
        st      r16, d_passes(own)
        sts     own, 0, -1(list)
        tne     r16, r0
        tget    r19
        sub     list, list, r19
        add     own, own, #kDescriptor
        next_preparation name, next, <st list, link_own>
        .endm

prepare_far:
        begin_preparation #stride, kListings
        sub     room, ring, #1
        shr     room, room, #log2_stride
        ld      list, link_own
prepare_far_loop:
        slf
        load_box
        sub     r24, last, here
        sub     r24, r24, #1
        tgeu    here, last
        tget    r25
        mul     r25, r25, ring
        add     r24, r24, r25
        shr     r16, r24, #log2_stride  ; to the last window that has a column,
        tgeu    here, first
        tltu.and here, last
        tget    r23
        sub     r24, room, r16          ; which is this lane's if there are columns on both sides
        mul     r24, r24, r23
        add     r16, r16, r24
        .if eq dense
        tne     r16, r0
        tget    r23
        add     r16, room, #1
        mul     r16, r16, r23
        .endc
        finish_listing prepare_far, pass_far
        .endc

; The window is the ring if there is one round only.
prepare_near:
        .if gt stride-1
        begin_preparation #stride, kListings
        mov     room, #stride
        ld      list, link_own
        .else
        ld      room, lanes
        begin_preparation room
        .endc
prepare_near_loop:
        slf
        load_box
        mov     r16, room
        .if ne dense
        tge     seam, first
        tget    r23
        mul     r23, r23, ring
        sub     r24, last, here         ; to the last destination, be it within the window
        add     r24, r24, r23
        tltu    r24, room
        tget    r25
        sub     r24, r24, room
        mul     r24, r24, r25
        add     r16, room, r24
        .endc
        .if gt stride-1
        in_window
        tget    r23
        mul     r16, r16, r23
        finish_listing prepare_near, pass_near
        .else
        finish_preparation prepare_near, pass_near
        .endc

        .macro  take_listed
        lds     slot, 0, (own)
        ld      to_go, d_passes(slot)
        add     own, own, #1
        .endm
        .macro  where_far
        find_window #stride
        mov     own_end, #list_top
        .endm
        .macro  wanted_far
        in_window
        .if eq dense
        tlt.and r0, to_go               ; its own lane has it
        .endc
        .endm

; `room` is above what has not been sent yet.
        .macro  take_last
        take_listed
        mov     room, slot
        .endm
        .macro  where_spread
        where_near
        mov     own_end, #list_top
        .endm
        .macro  wanted_spread
        wanted_near
        .endm

        .if gt stride-1
        pass_procedure pass_far, stride, far, far_passes, communicate_near, take=take_listed
        pass_procedure pass_near, 1, spread, near_passes, communicate_end, save=<st room, link_room>, take=take_last, order=down
        .else
        pass_procedure pass_near, 1, near, near_passes, communicate_end
        .endc

communicate_end:
        wake
        ld      r2, link_into
        .if gt stride-1
        add     r1, r2, #kDescriptor
        ld      r2, receive_end
        st      r1, received_at
        .else
        ld      r1, received_at
        .endc
        sub     r3, r2, r1
        mul     r3, r3, #65536/kDescriptor+1, 16        ; exact up to 2520 descriptors
        st      r2, received_end
        st      r3, receive_count
        setp    normalise
        line
