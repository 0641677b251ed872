; SPDX-License-Identifier: MIT
; Takes in the message that waits at port r3 and hands it to the routine for its kind, which owns the block from then on.
; Such a routine finds the message in r5, the port it came through (twice its number) in arrival_port, and may clobber
; all registers.

receive:
        asl     r3
        mov     r3, arrival_port
        call    get_block
        mov     port_address(r3), r0
        mov     rxlen(r0), b_length(r5)
        mov     r5, rxaddr(r0)
        incb    m_hops(r5)
        movb    (r5), r0
        asl     r0
        cmp     r0, #2*kind_span
        bhi     unknown_kind
        jmp     @handler(r0)

unknown_kind:
        mov     #fault_message, @#io_fault
        return

handler:
        .word   unknown_kind, facet_in, points_in, request_in, reply_in, triangle_in, span_in
