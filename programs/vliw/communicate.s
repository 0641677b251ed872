; SPDX-License-Identifier: MIT
; Sort-middle communication on columns: every descriptor comes to each lane whose column it covers, once (Eldridge 1995, 5.1 to 5.3, 7.4, A.2.2).
;
; Store and forward: a pass hands the descriptor in every lane's slot on to the lane `stride` (or 1) places right. What arrives is written
; behind what the lane keeps; if the lane wants it, it stays there, otherwise the next one overwrites it. Either way it is in the lane's slot
; for the next pass, unless nobody needs it any more: then the next of the lane's own is put in.
;
; d_passes says how far a descriptor has still to go: the passes to its last destination. Nobody needs it if there are none;
; such a one arrives with -1, a descriptor that has come to its last destination with 0.
;
; stride 1: one round, by passes of 1. A descriptor that its own lane wants goes all the way round, so none is ever copied.
; stride d: two rounds. The far one, by passes of d, brings a descriptor from lane s to each lane t = s + k d, k = 1 ... lanes / d, with a
;   destination among the d lanes behind t. What is kept is sent on in the near round, by at most d passes of 1, so that nobody gets it
;   twice. The near round receives into the other array, which the far one has sent from.
; dense 1: a descriptor goes no further than it must; 0: all the way, which is lanes / d passes, or d in the near round of two.
;
; Needs: columns numbered as lanes; lanes a multiple of stride, at most 32767; receive arrays (with strides the source array, too) with room
; for one descriptor more than they keep. Error 2 and halt: a lane keeps more.
; Memory: link_*. Counter: c2.

link_slot   = other_scratch         ; the descriptor to be passed on
link_into   = other_scratch+1       ; where the next one arrives
link_own    = other_scratch+2       ; next of the lane's own to be put in
link_end    = other_scratch+3       ; first word behind the lane's own
link_room   = other_scratch+4       ; greatest value of link_into
link_next   = other_scratch+5       ; next of the lane's own to be prepared

kPassOverhead = 30                  ; cycles of a pass beside its words, at most
kPassCycles = 820                   ; for passes on a scanline
kPreparations = 25                  ; descriptors prepared on a scanline

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

slot    = r1
into    = r2
own     = r3
own_end = r4
to_go   = r5            ; passes that the slot's descriptor still needs
here    = r6            ; this lane; in the near round's passes, its column
brink   = r7            ; the last lane of the window, which are the lanes behind this one that it sends to in the near round
seam    = r8            ; the same less lanes: for windows that go over the end of the ring
room    = r9
passed  = r10           ; passes in this procedure
handed  = r11           ; to_go as the next lane gets it
first   = r12           ; d_left
last    = r13           ; d_right
ring    = r14           ; lanes

; ---- A round begins. Sent is what lies from `own` to `own_end`, the receiving array is at (into_at) to (into_end).
        .macro  begin_round into_at, into_end, next
        ld      into, into_at
        ld      room, into_end
        sub     room, room, #kDescriptor
        st      own, link_own
        st      own, link_next
        st      own_end, link_end
        st      into, link_into
        st      into, link_slot
        st      room, link_room
        mov     to_go, #-1
        st      to_go, d_passes(into)   ; an empty slot
        setp    next
        line
        .endm

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
        begin_round receive_at, receive_end, prepare_near
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

; r16 is the number of passes; none if no sample lies within the box.
        .macro  finish_preparation name, next
        tge     last, first
        tge.and r18, r17
        tget    r19
        mul     r16, r16, r19
        st      r16, d_passes(own)
        add     own, own, #kDescriptor
        tltu    own, own_end
        bnor    name'_done
        dec     c2, name'_loop
        jump    name'_save
name'_done:
        setp    next
name'_save:
        wake
        st      own, link_next
        line
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

; ---- Passes
        .macro  pass_word k, from, to, ahead, next_from, places
        put     from
        right   places
        ld      next_from, ahead(slot)
        get     to
        st      to, k(into)
        .endm

; The first words of a descriptor come with d_left, d_right and d_passes, which are looked at.
        .macro  pass_descriptor places
        ld      r16, 0(slot)
        pass_word 0, r16, first, 1, r17, places
        pass_word 1, r17, last, 2, r18, places
        pass_word 2, r18, r22, 3, r19, places
        pass_word 3, r19, r23, 5, r17, places
        put     handed
        right   places
        get     to_go
        st      to_go, d_passes(into)
at = 5
        .rept   9
        pass_word at, r17, r21, at+1, r18, places
        pass_word at+1, r18, r22, at+2, r19, places
        pass_word at+2, r19, r23, at+3, r20, places
        pass_word at+3, r20, r24, at+4, r17, places
at = at+4
        .endr
        put     r17
        right   places
        get     r21
        st      r21, at(into)
        .endm

        .macro  pass_procedure name, places, kind, counter, next
name:
        wake
        ld      slot, link_slot
        ld      into, link_into
        ld      own, link_own
        ld      own_end, link_end
        ld      room, link_room
        ld      to_go, d_passes(slot)
        where_'kind
        mov     passed, #0
        .if ne line_locked
kPasses = kPassCycles/<2+places*kDescriptor+kPassOverhead>
        .if eq kPasses
        .error  a pass of `stride` places does not fit into a scanline
        .endc
        setc    c2, kPasses
        .endc
name'_loop:
        tge     r0, to_go
        tltu.and own, own_end
        slf
        mov     slot, own
        ld      to_go, d_passes(own)
        add     own, own, #kDescriptor
        wake
        tlt     r0, to_go
        tget    r16
        tltu.or own, own_end
        mul     handed, to_go, r16
        sub     handed, handed, #1
        bnor    name'_done
        pass_descriptor places
        wanted_'kind
        tge.and to_go, r0
        tget    r16
        mul     r16, r16, #kDescriptor
        mov     slot, into
        add     into, into, r16
        add     passed, passed, #1
        tltu    room, into
        bor     receive_overflow
        .if ne line_locked
        dec     c2, name'_loop
        jump    name'_save
        .else
        jump    name'_loop
        .endc
name'_done:
        setp    next
name'_save:
        st      slot, link_slot
        st      into, link_into
        st      own, link_own
        ld      r16, counter
        ld      r17, counter+1
        adds    r16, r16, passed
        adc     r17, r17, r0
        st      r16, counter
        st      r17, counter+1
        line
        .endm

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

        .macro  where_near
        ld      here, column
        .endm
        .macro  wanted_near
        tge     here, first
        tge.and last, here
        .endm

        .if gt stride-1
        pass_procedure pass_far, stride, far, far_passes, communicate_near
        .endc
        pass_procedure pass_near, 1, near, near_passes, communicate_end

receive_overflow:
        slf
        mov     r16, #2
        st      r16, error
        wake
        halt

communicate_end:
        wake
        .if gt stride-1
        ld      r1, source_at
        .else
        ld      r1, receive_at
        .endc
        ld      r2, link_into
        sub     r3, r2, r1
        mul     r3, r3, #65536/kDescriptor+1, 16        ; exact up to 2520 descriptors
        st      r1, received_at
        st      r2, received_end
        st      r3, receive_count
        setp    normalise
        line
