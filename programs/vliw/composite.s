; SPDX-License-Identifier: MIT
; Compositing (Eldridge 1995, 6.3): the members of a region's lanes bring its pixels together, each on one of them, by passes of `group` places.
;
; A set are as many pixels of the region as it has members, m. The set that begins with pixel s (region.s) is done in m - 1 passes, in which all
; lanes are busy: pixel s + j starts at member j + 1, goes from member to member, the nearest so far, and ends at member j. Two pixels compare as
; numbers of 48 bits, so the order in which they meet makes no difference.
; A lane takes each of its pixels out once: then its depth is 0 again, ready for the next band.
;
; The picture: a lane of member k keeps pixel s + k of every set, three words as in memory.s, in bank 0 from kGathered on, set after set, band after
; band. So pixel p of region r in band b is on lane r + group (p mod m), at kGathered + 3 (b S + p div m), S = ceil(kRegion / m). Error 4 and
; halt: it has no room.
; deferred: a pixel is shaded when it is taken out, while others are in transit.
; Passes are counted in pixel_passes. Memory: composite_at. Counters: c2 passes left in the set; c3 of a scanline.

most_lanes = 32767*group                ; members are counted by a signed word
        .if lt 65536-most_lanes
most_lanes = 65536
        .endc

composite_at = other_scratch+64         ; registers r1 ... r3, r11, r12, from scanline to scanline
composite_picture = other_scratch+70    ; where the set's pixel goes

near0   = r1                            ; the nearest so far
near1   = r2
near2   = r3
own0    = r4                            ; the lane's own
own1    = r5
own2    = r6
came0   = r7                            ; what has come
came1   = r8
came2   = r9
here_at = r10                           ; address of the lane's own pixel
set     = r11                           ; first pixel of the set
turn    = r12                           ; here_at - set
count   = r13                           ; members

        .macro  composite_words op
at = composite_at
        .irp    reg, <near0, near1, near2, set, turn>
        op      reg, at
at = at+1
        .endr
        ld      count, members
        .endm

; The lane's own pixel number `turn` of the set, taken out.
        .macro  take_pixel
        add     here_at, set, turn
        lds     own0, 1, (here_at)
        lds     own1, 2, (here_at)
        lds     own2, 3, (here_at)
        sts     r0, 1, (here_at)
        .if ne deferred
        shade   own0, own1, own2, here_at
        .endc
        .endm

; The next is one place before it, in a circle.
        .macro  turn_back
        sub     turn, turn, #1
        mul     r14, turn, #1, 15
        and     r14, r14, count
        add     turn, turn, r14
        .endm

; Deferred, shifts by one place at a time leave all other units to shading.
        .macro  shift_group
        .if ne deferred
        .rept   group
        right   1
        .endr
        .else
        right   group
        .endc
        .endm

        .macro  pass_pixel
        turn_back
        take_pixel
        put     near2
        shift_group
        get     came2
        put     near1
        shift_group
        get     came1
        put     near0
        shift_group
        get     came0
        subs    r0, own2, came2
        sbc     r0, own1, came1
        sbc     r0, own0, came0
        mov     near0, own0
        mov     near1, own1
        mov     near2, own2
        tltb    r0, r0
        slf
        mov     near0, came0
        mul     near1, came1, #1
        mov     near2, came2
        wake
        .endm

kShading    = 0
        .if ne deferred
        .include "shade.s"
        .endc
kHopCycles  = 3*<2+group>+15
        .if lt kHopCycles-kShading
kHopCycles  = kShading
        .endc
kHops       = kPassCycles-40-kShading/kHopCycles        ; on a scanline that begins a set and ends it
        .if ne line_locked
        .if lt kHops-1
        .error  a pass of `group` places does not fit into a scanline
        .endc
        .endc

composite:
        wake
        phase   5
        .if gt bands-1
        ld      r14, row_first
        tne     r14, r0
        bt      composite_band
        .endc
        mov     r15, #kGathered
        st      r15, composite_picture
composite_band:
        mov     set, r0
        composite_words st
        setp    composite_set
        line

composite_set:
        wake
        composite_words ld
        .if ne line_locked
        setc    c3, kHops
        .endc
composite_next_set:
        ld      r15, composite_picture
        sub     r16, r15, #kGathered
        tgeu    r16, #kGatheredEnd-kGathered-kPixel+1
        bor     picture_full
        ld      turn, member
        turn_back
        take_pixel
        mov     near0, own0
        mov     near1, own1
        mov     near2, own2
        sub     r15, count, #1
        put     r15
        ldc     c2
        teq     r15, r0
        bt      composite_set_done
composite_pass:
        pass_pixel
        .if ne line_locked
        dec     c3, composite_more
        composite_words st
        setp    composite_on
        line
composite_more:
        .endc
        dec     c2, composite_pass
composite_set_done:
        ld      r15, composite_picture
        tne     near0, r0               ; what is not drawn is black
        tget    r14
        mul     near1, near1, r14
        mul     near2, near2, r14
        sts     near0, 0, (r15)
        sts     near1, 0, 1(r15)
        sts     near2, 0, 2(r15)
        add     r15, r15, #kPixel
        st      r15, composite_picture
        ld      r16, pixel_passes
        ld      r17, pixel_passes+1
        sub     r18, count, #1
        adds    r16, r16, r18
        adc     r17, r17, r0
        st      r16, pixel_passes
        st      r17, pixel_passes+1
        mov     r19, #kRegion-1
        sub     r19, r19, set
        add     set, set, count
        tgeu    r19, count
        .if ne line_locked
        composite_words st
        setp    composite_set
        bt      composite_line
        .else
        bt      composite_next_set
        .endc
        next_band
composite_line:
        line

        .if ne line_locked
composite_on:
        wake
        composite_words ld
        setc    c3, kHops
        jump    composite_more
        .endc

picture_full:
        mov     r16, #4
        st      r16, error
        halt
