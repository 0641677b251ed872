; SPDX-License-Identifier: MIT
; Sort-first communication on columns (Eldridge 1995, 3.2.1, 4.3.2): of every visible polygon each lane whose column its box meets has one, the home or a
; copy, once. Copies go to the right by passes of 1 place and no further than they must; a box around its home, which has columns on both sides, goes
; round the ring. What a lane draws is listed by address from `wanted` to wanted_end; copies lie in the receive array, kHome words each.
;
; Needs: columns numbered as lanes; at most 32767 lanes, as passes to go are signed words; a receive array with room for one copy more than it keeps: otherwise error 2 and halt.
; Memory, counter: see pass.s.

distribute:
        wake
        phase   2
        st      r0, near_passes
        st      r0, near_passes+1
        begin_list wanted, wanted_end
        mov     own, #movers
        mov     own_end, own
        mov     r16, #homes
        begin_round receive_at, receive_end, prepare_copies, h, kHome, r16

prepare_copies:
        ld      list, wanted_end
        begin_walk
prepare_copies_loop:
        look_home
        tge     last, first
        tget    r19
        tge.and last, here
        tge.and here, first
        tget    r21
        sts     slot, 0, (list)
        add     list, list, r21
        distance r16, last, r17
        sub     r22, ring, #1           ; columns on both sides: round the ring to the lane before this one
        sub     r22, r22, r16
        tlt.and first, here
        tget    r23
        mul     r22, r22, r23
        add     r16, r16, r22
        mul     r16, r16, r19
        tlt     r0, r16
        tget    r18
        send_home r16, r18
        end_walk prepare_copies, pass_copies, list, wanted_end

        pass_procedure pass_copies, 1, near, near_passes, geometry, list_it, <st list, wanted_end>, h, kHome, take_h
