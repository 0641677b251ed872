; SPDX-License-Identifier: MIT
; Message blocks and the queues in front of the ports. Every block has one owner: the free list, a queue, a list of the
; program's, or the routine that has it in r5. A message that cannot leave at once waits in its port's queue, and the
; program goes on taking messages in, so that store and forward does not lock up while there are blocks.

reserve_receive  = 6.           ; free blocks below which no message is taken in
reserve_generate = 24.          ; below which no new spans are made while others wait to leave
reserve_low      = 32.          ; below which triangles are drawn or sent at once rather than kept

; A fresh block in r5. Clobbers nothing else. Blocks never used before are taken from the pool's untouched end. Waits for
; a queued message to leave if there is none.
get_block:
        mov     free_list, r5
        beq     1$
        mov     b_link(r5), free_list
        dec     free_count
        return
1$:     mov     pool_next, r5
        cmp     r5, pool_last
        bhi     2$
        add     block_size, pool_next
        dec     free_count
        return
2$:     tst     queue_mask
        bne     3$
        mov     #fault_pool, @#io_fault
3$:     mov     r0, -(sp)
        mov     r3, -(sp)
        mov     queue_mask, @#io_waitfor
        call    pump
        mov     (sp)+, r3
        mov     (sp)+, r0
        br      get_block

; Sends the message in block r5 through port r3 (twice its number), now or when there is room. The block is given away.
; Clobbers r0.
send:   mov     port_address(r3), r0
        bit     #tx_room_bit, (r0)
        beq     enqueue
        tst     queue_head(r3)
        bne     enqueue
        mov     r5, txaddr(r0)
        mov     b_length(r5), txlen(r0)

; Frees block r5. Clobbers nothing.
free_block:
        mov     free_list, b_link(r5)
        mov     r5, free_list
        inc     free_count
        return

enqueue:
        clr     b_link(r5)
        tst     queue_head(r3)
        bne     1$
        mov     r5, queue_head(r3)
        bis     port_bit(r3), queue_mask
        mov     r5, queue_tail(r3)
        return
1$:     mov     queue_tail(r3), r0
        mov     r5, b_link(r0)
        mov     r5, queue_tail(r3)
        return

; Sends a copy of the message in block r5, which stays the caller's. Clobbers r0.
send_copy:
        mov     port_address(r3), r0
        bit     #tx_room_bit, (r0)
        beq     1$
        tst     queue_head(r3)
        bne     1$
        mov     r5, txaddr(r0)
        mov     b_length(r5), txlen(r0)
        return
1$:     mov     r5, -(sp)
        call    copy_block
        call    enqueue
        mov     (sp)+, r5
        return

; A copy of block r5 in a fresh block, which r5 points to then. Clobbers r0.
copy_block:
        mov     r1, -(sp)
        mov     r2, -(sp)
        mov     r5, r1
        call    get_block
        mov     b_length(r1), r0
        mov     r0, b_length(r5)
        inc     r0
        asr     r0                      ; words
        mov     r5, r2
1$:     mov     (r1)+, (r2)+
        sob     r0, 1$
        mov     (sp)+, r2
        mov     (sp)+, r1
        return

; Sends a copy of block r5 to every neighbour but the one at port r4 (twice its number; -1 leaves out none).
; Clobbers r0, r3.
send_all:
        mov     last_port, r3
1$:     cmp     r3, r4
        beq     2$
        call    send_copy
2$:     sub     #2, r3
        bge     1$
        return

; Sends the oldest message of each queue whose port has room. Clobbers r0, r3.
pump:   mov     r5, -(sp)
        mov     last_port, r3
1$:     mov     queue_head(r3), r5
        beq     2$
        mov     port_address(r3), r0
        bit     #tx_room_bit, (r0)
        beq     2$
        mov     r5, txaddr(r0)
        mov     b_length(r5), txlen(r0)
        mov     b_link(r5), queue_head(r3)
        call    free_block
        tst     queue_head(r3)
        bne     2$
        bic     port_bit(r3), queue_mask
2$:     sub     #2, r3
        bge     1$
        mov     (sp)+, r5
        return
