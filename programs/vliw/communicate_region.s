; SPDX-License-Identifier: MIT
; Sort-twice communication (Eldridge 1995, 6.2, A.2.2): every descriptor comes to the first lane, from its own on to the right, of each region that
; its box meets, once; no such lane is further away than group - 1. group 1: each lane draws its own, and nothing is sent.
;
; What the lane draws is listed by address from `wanted` to wanted_end: some of its own, where they are, and what it receives. Its own are listed
; at the preparation, so they never travel round the ring.
; dense 1: a descriptor goes no further than it must; 0: group - 1 passes.
; Received is behind the lane's own, up to receive_end.
; Needs lanes a multiple of group: otherwise error 3 and halt. Room for one descriptor more than the lane keeps: error 2.

        .include "pass.s"

right_end = r7                          ; region_right
left_end = r8                           ; region_left

communicate:
        wake
        phase   2
        find_region
        begin_list wanted, wanted_end
        st      r0, near_passes
        st      r0, near_passes+1
        st      r0, pixel_passes
        st      r0, pixel_passes+1
        ld      own, source_at
        ld      own_end, source_count
        mul     own_end, own_end, #kDescriptor
        add     own_end, own_end, own
        .if gt group-1
        st      own_end, received_at
        begin_round received_at, receive_end, prepare_region
        .else
        st      own, link_next
        st      own_end, link_end
        setp    prepare_region
        line
        .endc

        .macro  where_region
        ld      right_end, region_right
        ld      left_end, region_left
        ld      list, wanted_end
        .endm
        .macro  wanted_region mode
        tge'mode right_end, first
        tge.and last, left_end
        .endm

; r16: passes to the last lane.
        .macro  passes_to_go
        .if ne dense
        mulu    r16, last, #kPerColumns, kColumnsPick   ; regions of the box's sides
        mulu    r21, first, #kPerColumns, kColumnsPick
        tge     r16, here               ; from this region through the last one back to the first: almost a whole turn
        tlt.and r21, here
        tget    r22
        sub     r16, r16, here
        tlt     r16, r0
        tget    r23
        mul     r23, r23, #group
        add     r16, r16, r23
        sub     r24, r16, #group-1
        mul     r24, r24, r22
        sub     r16, r16, r24
        .else
        mov     r16, #group-1
        .endc
        .endm

prepare_region:
        wake
        ld      own, link_next
        ld      own_end, link_end
        ld      here, region
        where_region
        setc    c2, kPreparations
        tltu    own, own_end
prepare_region_loop:
        slf
        ld      first, d_left(own)
        ld      last, d_right(own)
        ld      r17, d_top(own)
        ld      r18, d_bottom(own)
        tge     r18, r17
        tge.and last, first
        wanted_region .and
        tget    r20
        sts     own, 0, (list)
        add     list, list, r20
        .if gt group-1
        passes_to_go
        finish_preparation prepare_region, pass_region, <st list, wanted_end>
        .else
        mov     r16, r0
        finish_preparation prepare_region, normalise, <st list, wanted_end>
        .endc

        .if gt group-1
        pass_procedure pass_region, 1, region, near_passes, normalise, list_it, <st list, wanted_end>
        .endc

lanes_left_over:
        mov     r16, #3
        st      r16, error
        halt
