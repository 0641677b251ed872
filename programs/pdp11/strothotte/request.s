; SPDX-License-Identifier: MIT
; Points that are missing. A facet may stand one processor away from where it points, so that a vertex can be two or
; more hops from here. In ASSEMBLE all neighbours are asked, who know their neighbours' points, too. In SEEK what is
; still missing is asked for farther away; each processor passes on a question once.

max_pending = 32.               ; triangles put off
seek_hops   = 4                 ; how far SEEK asks; a path has room for four ports
max_seen    = 16.               ; questions remembered, a power of two

; Puts off the triangle with record r4 of own_points, for which facet r0 is missing. Clobbers all.
put_off:
        mov     pending_top, r1
        cmp     r1, #2*max_pending
        bhis    1$
        mov     r4, pending_record(r1)
        mov     own_points, pending_points(r1)
        mov     r0, pending_facet(r1)
        add     #2, pending_top
        br      ask                     ; unless it has been asked for already
1$:     mov     #fault_pending, @#io_fault
        return

; Asks for facet r0 unless an earlier pending triangle (below r1) has done so. Clobbers all.
ask:    mov     r1, r2
        beq     2$
1$:     sub     #2, r2
        cmp     pending_facet(r2), r0
        beq     3$
        tst     r2
        bne     1$
2$:     call    get_block
        mov     #kind_request, (r5)
        mov     r0, q_id(r5)
        mov     request_hops, q_left(r5) ; and depth 0
        clr     q_path(r5)
        mov     @#io_node, q_origin(r5)
        mov     #q_size, b_length(r5)
        mov     port_count, @#io_credit
        mov     #-1, r4
        call    send_all
        jmp     free_block
3$:     return

; SEEK: ask again, farther.
seek:   doing   mark_assemble
        mov     #seek_hops, request_hops
        clr     r1
1$:     cmp     r1, pending_top
        bhis    2$
        mov     pending_facet(r1), r0
        mov     r1, -(sp)
        call    ask
        mov     (sp)+, r1
        add     #2, r1
        br      1$
2$:     return

; A neighbour asks. Answer, pass on, or drop.
request_in:
        doing   mark_assemble
        mov     arrival_port, r3
        mov     q_path(r5), r1          ; the way back: this port first
        asl     r1
        asl     r1
        asl     r1
        asl     r1
        mov     r3, r0
        asr     r0
        bis     r0, r1
        mov     r1, q_path(r5)
        incb    q_depth(r5)
        mov     q_id(r5), r0
        call    locate
        bne     answer
        decb    q_left(r5)
        beq     1$
        call    seen
        beq     1$
        mov     port_count, r0
        sub     #2, r0                  ; all ports but one, for one message consumed
        mov     r0, @#io_credit
        mov     arrival_port, r4
        call    send_all
        jmp     free_block
1$:     mov     #-1, @#io_credit
        jmp     free_block

; The points in block r0 go back the way the request in r5 came.
answer: mov     r5, r4
        mov     r0, r5
        call    copy_block
        mov     #kind_reply, (r5)
        movb    q_depth(r4), p_depth(r5)
        mov     q_path(r4), p_path(r5)
        mov     r5, -(sp)
        mov     r4, r5
        call    free_block
        mov     (sp)+, r5
send_back:
        decb    p_depth(r5)
        mov     p_path(r5), r3
        mov     r3, r0
        ash     #-4, r0
        mov     r0, p_path(r5)
        bic     #177760, r3
        asl     r3
        jmp     send

; An answer comes: send it on, or complete the triangles that wait for it.
reply_in:
        doing   mark_assemble
        tstb    p_depth(r5)
        bne     send_back
        mov     p_id(r5), r0
        call    locate
        beq     1$
        mov     #-1, @#io_credit        ; known by now
        jmp     free_block
1$:     call    add_points
        mov     p_id(r5), r0
        call    resume
        mov     #-1, @#io_credit
        return

; Tries all triangles again that wait for facet r0; one that waits for another, too, is put off again.
; Clobbers all.
resume: mov     r0, resumed
        mov     pending_top, r1
1$:     tst     r1
        beq     3$
        sub     #2, r1
        cmp     pending_facet(r1), resumed
        bne     1$
        mov     pending_record(r1), r4
        mov     pending_points(r1), own_points
        sub     #2, pending_top
        mov     pending_top, r2
        mov     pending_record(r2), pending_record(r1)
        mov     pending_points(r2), pending_points(r1)
        mov     pending_facet(r2), pending_facet(r1)
        mov     r1, -(sp)
        call    triangle
        mov     (sp)+, r1
        br      1$
3$:     return

; Has the question in r5 been passed on already? Z set if so; else it is remembered. Clobbers r0, r1, r2.
seen:   mov     #max_seen, r0
        mov     #seen_id, r1
1$:     cmp     (r1)+, q_id(r5)
        bne     2$
        cmp     seen_origin-seen_id-2(r1), q_origin(r5)
        beq     3$
2$:     sob     r0, 1$
        mov     seen_next, r1
        mov     q_id(r5), seen_id(r1)
        mov     q_origin(r5), seen_origin(r1)
        add     #2, r1
        bic     #2*max_seen, r1
        mov     r1, seen_next
        clz
3$:     return
