; SPDX-License-Identifier: MIT
; Migration (Eldridge 1995, 5.5): every visible polygon's only copy moves to the lane of the left column of its box, the shorter way round, by passes
; of 1 place to the right, then by others to the left. Polygons that are not visible stay; migrate 2: they move as well, with the left column of what
; they would cover (or the last lane), so that they are not far from where they come into sight. This goes before distribution, by the boxes of the
; picture to come: copies are passed to the right only, and what has moved to the left since would otherwise have to go round the ring.
;
; A lane that has no room lets a polygon pass: it goes on until some lane has, which there is, because at first all were at home. To the right first:
; so what had no room turns back in the second round and ends to the left of its column, from where copies have not far to go.
;
; A polygon under way is in the first of the lane's free homes. Those that are to leave hold theirs until they do; then it is the first free one, and
; what comes in the same pass may lie there. Memory, counter: see pass.s. Passes are counted in migration_passes.

stays       = r25       ; home_end
free        = r26       ; home_free
last_free   = r27

        .macro  migration way, next
migrate_'way:
        wake
        .if idn way, right
        phase   6
        st      r0, migration_passes
        st      r0, migration_passes+1
        .endc
        mov     r1, #homes
        mov     r2, #movers
        ld      r3, home_free
        lds     r4, 0, (r3)
        mov     r5, #-1
        st      r5, h_passes(r4)        ; nothing under way
        st      r1, link_next
        st      r1, home_end
        st      r2, link_own
        st      r2, link_end
        setp    leave_'way
        line

leave_'way:
        ld      stays, home_end
        begin_walk
leave_'way'_loop:
        look_home
        .if gt migrate-1
        sub     r21, ring, #1
        lesser  first, r21, r17, r18
        distance r16, first, r17
        sub     r18, ring, r16
        tlt     r0, r16
        .else
        distance r16, first, r17
        sub     r18, ring, r16
        tge     last, first
        tlt.and r0, r16
        .endc
        .if idn way, right
        tge.and r18, r16
        tget    r19
        send_home r16, r19
        .else
        tlt.and r18, r16
        tget    r19
        send_home r18, r19
        .endc
        xor     r20, r19, #1
        sts     slot, 0, (stays)
        add     stays, stays, r20
        end_walk leave_'way, move_'way, stays, home_end

move_'way:
        wake
        ld      own, link_own
        ld      own_end, link_end
        ld      stays, home_end
        ld      free, home_free
        ld      last_free, home_last
        lds     slot, 0, (free)
        ld      to_go, h_passes(slot)
        mov     passed, #0
        limit_passes 1, kHome
move_'way'_loop:
        tlt     to_go, r0
        tltu.and own, own_end
        slf
        take_h
        sub     free, free, #1
        sts     slot, 0, (free)
        wake
        anything_to_pass
        bnor    move_'way'_done
        mov     into, slot
        pass_h  1, way
        teq     to_go, r0
        tget    r17
        tltu.and free, last_free
        tget    r16
        sts     slot, 0, (stays)
        add     stays, stays, r16
        add     free, free, r16
        add     to_go, to_go, r17       ; one more where there is no room,
        sub     to_go, to_go, r16
        sub     to_go, to_go, r16       ; -1 where there is
        lds     slot, 0, (free)
        add     passed, passed, #1
        next_pass move_'way
move_'way'_done:
        setp    next
move_'way'_save:
        st      to_go, h_passes(slot)
        st      own, link_own
        st      stays, home_end
        st      free, home_free
        count_passes migration_passes
        line
        .endm

        migration right, migrate_left
        migration left, settled

settled:
        wake
        ld      r1, home_end
        ld      r2, most_homes
        sub     r1, r1, #homes
        st      r1, polygons
        tlt     r2, r1
        slf
        st      r1, most_homes
        wake
        setp    distribute
        line
