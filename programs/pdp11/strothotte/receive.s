; SPDX-License-Identifier: MIT
; Takes in the message that waits at port r3 and hands it to the routine for its kind, which owns the block from then on.
; Such a routine finds the message in r5, the port it came through (twice its number) in arrival_port, and may clobber
; all registers.

receive:
        asl     r3
        mov     r3, arrival_port
        mov     free_list, r5           ; a block: most often one that was freed
        beq     1$
        mov     b_link(r5), free_list
        dec     free_count
2$:     mov     port_address(r3), r0
        mov     rxlen(r0), b_length(r5)
        mov     r5, rxaddr(r0)
        incb    m_hops(r5)
        movb    (r5), r0
        asl     r0
        cmp     r0, #2*kind_span
        bhi     unknown_kind
        jmp     @handler(r0)
1$:     call    get_block
        br      2$

unknown_kind:
        mov     #fault_message, @#io_fault
        return

handler:
        .word   unknown_kind, facet_in, points_in, request_in, reply_in, triangle_in, span_in
