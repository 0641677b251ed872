; SPDX-License-Identifier: MIT
; Passes of records from lane to lane, for communicate.s and communicate_region.s (descriptors), distribute.s and migrate.s (polygons of homes.s).
; Store and forward: a pass hands the record in every lane's slot on to a lane on the right. What arrives is written behind what the lane
; keeps; if the lane wants it, it stays there, otherwise the next one overwrites it. Either way it is in the lane's slot for the next
; pass, unless nobody needs it any more: then the next of the lane's own is put in.
;
; d_passes (h_passes) says how far a record has still to go: the passes to its last destination. Nobody needs it if there are none;
; such a one arrives with -1, a record that has come to its last destination with 0.
;
; A kind of record is a letter: d for descriptors, h for homes. take_d puts the lane's next own into the slot, pass_d passes it, with first, last and
; to_go read on the way; d_passes is its word.
; Memory: link_*. Counter: c2.

link_slot   = other_scratch         ; the record to be passed on
link_into   = other_scratch+1       ; where the next one arrives
link_own    = other_scratch+2       ; next of the lane's own to be put in
link_end    = other_scratch+3       ; first word behind the lane's own
link_room   = other_scratch+4       ; greatest value of link_into, least where that goes down
link_next   = other_scratch+5       ; next of the lane's own to be prepared

kPassOverhead = 30                  ; cycles of a pass beside its words, at most
kPassCycles = 820                   ; for passes on a scanline
kPreparations = 25                  ; records prepared on a scanline

slot    = r1
into    = r2
own     = r3
own_end = r4
to_go   = r5            ; passes that the slot's descriptor still needs
here    = r6            ; this lane; in the near round's passes, its column
room    = r9
passed  = r10           ; passes in this procedure, lower and upper word
passed_upper = r25
handed  = r11           ; to_go as the next lane gets it
first   = r12           ; d_left
last    = r13           ; d_right
ring    = r14           ; lanes

; ---- A round begins. Sent is what lies from `sent` to its end, what is prepared for it from `prepare` to own_end, the receiving array is at
; (into_at) to (into_end). start_round: it begins at `into`, and `room` is the limit of link_into.
        .macro  begin_round into_at, into_end, next, record=d, words=kDescriptor, prepare=own, sent=own
        ld      into, into_at
        ld      room, into_end
        sub     room, room, #words
        start_round next, record, prepare, sent
        .endm

        .macro  start_round next, record=d, prepare=own, sent=own
        mov     r17, sent
        st      r17, link_own
        st      prepare, link_next
        st      own_end, link_end
        st      into, link_into
        st      into, link_slot
        st      room, link_room
        mov     to_go, #-1
        st      to_go, record'_passes(into)     ; an empty slot
        setp    next
        line
        .endm

; reg: 1 if a sample lies within the box, else 0.
        .macro  may_be_seen reg
        tge     last, first
        tge.and r18, r17
        tget    reg
        .endm

; r16 is the number of passes; none if no sample lies within the box.
        .macro  finish_preparation name, next, save
        may_be_seen r19
        mul     r16, r16, r19
        st      r16, d_passes(own)
        add     own, own, #kDescriptor
        next_preparation name, next, <save>
        .endm

        .macro  next_preparation name, next, save
        tltu    own, own_end
        bnor    name'_done
        dec     c2, name'_loop
        jump    name'_save
name'_done:
        setp    next
name'_save:
        wake
        save
        st      own, link_next
        line
        .endm

; ---- Passes
        .macro  pass_word k, to, ahead, places, way=right
        put     r17
        way     places
        ld      r17, ahead(slot)
        get     to
        st      to, k(into)
        .endm

        .macro  take_d
        mov     slot, own
        ld      to_go, d_passes(own)
        add     own, own, #kDescriptor
        .endm

; The first words of a descriptor come with d_left, d_right and d_passes, which are looked at. Each word takes the same registers: few
; registers' values at the end are cheap to emulate.
        .macro  pass_d  places
        ld      r17, 0(slot)
        pass_word 0, first, 1, places
        pass_word 1, last, 2, places
        pass_word 2, r21, 3, places
        pass_word 3, r21, 5, places
        put     handed
        right   places
        get     to_go
        st      to_go, d_passes(into)
at = 5
        .rept   kDescriptor-6
        pass_word at, r21, at+1, places
at = at+1
        .endr
        put     r17
        right   places
        get     r21
        st      r21, at(into)
        .endm

; The lane draws one column.
        .macro  where_near
        ld      here, column
        .endm
        .macro  wanted_near
        tge     here, first
        tge.and last, here
        .endm

; T := T or the lane has something to pass; handed: what the next lane gets as to_go. r16: spoilt.
        .macro  anything_to_pass
        tlt     r0, to_go
        tget    r16
        tltu.or own, own_end
        mul     handed, to_go, r16
        sub     handed, handed, #1
        .endm

        .macro  count_passes counter, upper=r0
        ld      r16, counter
        ld      r17, counter+1
        adds    r16, r16, passed
        adc     r17, r17, upper
        st      r16, counter
        st      r17, counter+1
        .endm

; c2 := passes of a scanline.
        .macro  limit_passes places, words
        .if ne line_locked
kPasses = kPassCycles/<2+places*words+kPassOverhead>
        .if eq kPasses
        .error  a pass so far as stride says does not fit into a scanline
        .endc
        setc    c2, kPasses
        .endc
        .endm

        .macro  next_pass name
        .if ne line_locked
        dec     c2, name'_loop
        jump    name'_save
        .else
        jump    name'_loop
        .endc
        .endm

; Macros where_kind: the lane's registers for wanted_kind, which sets T if the lane wants what has come. keep: done with r16 = 1 on lanes that
; keep it at `into`, 0 on others; save: at the procedure's end. words: of a record. take: puts the lane's next own into the slot. order: where the
; lane keeps the next, above or below.
        .macro  pass_procedure name, places, kind, counter, next, keep, save, record=d, words=kDescriptor, take=take_d, order=up
name:
        wake
        ld      slot, link_slot
        ld      into, link_into
        ld      own, link_own
        ld      own_end, link_end
        ld      room, link_room
        ld      to_go, record'_passes(slot)
        where_'kind
        mov     passed, r0
        mov     passed_upper, r0
        limit_passes places, words
name'_loop:
        tge     r0, to_go
        tltu.and own, own_end
        slf
        take
        wake
        anything_to_pass
        bnor    name'_done
        pass_'record places
        wanted_'kind
        tge.and to_go, r0
        tget    r16
        keep
        adds    passed, passed, #1
        adc     passed_upper, passed_upper, r0
        mul     r16, r16, #words
        mov     slot, into
        .if idn order, up
        add     into, into, r16
        tltu    room, into
        .else
        sub     into, into, r16
        tltu    into, room
        .endc
        bor     receive_overflow
        next_pass name
name'_done:
        setp    next
name'_save:
        st      slot, link_slot
        st      into, link_into
        st      own, link_own
        save
        count_passes counter, passed_upper
        line
        .endm

receive_overflow:
        slf
        mov     r16, #2
        st      r16, error
        wake
        halt
