; SPDX-License-Identifier: MIT
; Sort-middle communication on columns: every descriptor comes to each lane whose column it covers, once (Eldridge 1995, 5.1 to 5.3, 7.4, A.2.2).
;
; stride 1: one round, by passes of 1. A descriptor that its own lane wants goes all the way round, so none is ever copied. Received is behind the
;   last descriptor to be sent: so it makes no difference how many a lane sends, as long as both fit.
; stride d: two rounds. The far one, by passes of d, brings a descriptor from lane s to each lane t = s + k d, k = 1 ... lanes / d, with a
;   destination among the d lanes behind t. What is kept is sent on in the near round, by at most d passes of 1, so that nobody gets it
;   twice. The near round receives into the other array, which the far one has sent from.
; dense 1: a descriptor goes no further than it must; 0: all the way, which is lanes / d passes, or d in the near round of two.
;
; Needs: columns numbered as lanes; lanes a multiple of stride, at most 32767; receive arrays (with strides the source array, too) with room
; for one descriptor more than they keep. Error 2 and halt: a lane keeps more.
; Memory, counter: see pass.s.

reach = 1
log2_stride = 0
        .rept   9
        .if lt reach-stride
reach = reach*2
log2_stride = log2_stride+1
        .endc
        .endr
        .if ne reach-stride
        .error  stride must be a power of two, 1 to 512
        .endc

brink   = r7            ; the last lane of the window, which are the lanes behind this one that it sends to in the near round
seam    = r8            ; the same less lanes: for windows that go over the end of the ring

        .include "pass.s"

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
        .if gt stride-1
        begin_round receive_at, receive_end, prepare_far
        .else
        st      own_end, received_at
        begin_round received_at, receive_end, prepare_near
        .endc

        .if gt stride-1
communicate_near:
        wake
        ld      own, receive_at
        ld      own_end, link_into
        begin_round source_at, source_end, prepare_near
        .endc

; ---- Preparation: d_passes of the lane's own; `full` register: as many as it may be.
        .macro  begin_preparation window
        wake
        ld      own, link_next
        ld      own_end, link_end
        ld      here, lane
        ld      ring, lanes
        add     brink, here, window
        sub     seam, brink, ring
        setc    c2, kPreparations
        tltu    own, own_end
        .endm

; The box; a screen that is wider than the ring ends with the ring.
        .macro  load_box
        ld      first, d_left(own)
        ld      last, d_right(own)
        ld      r17, d_top(own)
        ld      r18, d_bottom(own)
        sub     r20, ring, #1
        tlt     r20, last
        tget    r21
        sub     r22, r20, last
        mul     r22, r22, r21
        add     last, last, r22
        st      last, d_right(own)
        .endm

        .if gt stride-1
prepare_far:
        begin_preparation #stride
        shr     room, ring, #log2_stride
prepare_far_loop:
        slf
        load_box
        mov     r16, room               ; all the way, if a destination lies among the lanes behind this one
        .if ne dense
        tlt     here, last
        tge.and brink, first
        tge.or  seam, first
        tget    r23
        sub     r24, last, here         ; otherwise to the last window that has one
        sub     r24, r24, #1
        tlt     r24, r0
        tget    r25
        mul     r25, r25, ring
        add     r24, r24, r25
        shr     r24, r24, #log2_stride
        sub     r16, room, r24
        mul     r16, r16, r23
        add     r16, r16, r24
        .endc
        finish_preparation prepare_far, pass_far
        .endc

; The window is the ring if there is one round only.
prepare_near:
        .if gt stride-1
        mov     room, #stride
        .else
        ld      room, lanes
        .endc
        begin_preparation room
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
        finish_preparation prepare_near, pass_near

        .macro  where_far
        ld      here, lane
        ld      ring, lanes
        add     brink, here, #stride
        sub     seam, brink, ring
        .endm
        .macro  wanted_far
        tlt     here, last
        tge.and brink, first
        tge.or  seam, first
        .endm

        .if gt stride-1
        pass_procedure pass_far, stride, far, far_passes, communicate_near
        .endc
        pass_procedure pass_near, 1, near, near_passes, communicate_end

communicate_end:
        wake
        .if gt stride-1
        ld      r1, source_at
        st      r1, received_at
        .else
        ld      r1, received_at
        .endc
        ld      r2, link_into
        sub     r3, r2, r1
        mul     r3, r3, #65536/kDescriptor+1, 16        ; exact up to 2520 descriptors
        st      r2, received_end
        st      r3, receive_count
        setp    normalise
        line
