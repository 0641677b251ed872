; SPDX-License-Identifier: MIT
; One side of a polygon as records, from its top vertex (at r5) to the first one on the lowest row or below it; sp is where the
; next record goes.

; Clobbers r0, r1, r3.
        .macro  digest_slope at
        mov     at(r4), r1
        sub     at(r5), r1
        divide  r2, r3
        .if ne full
        join_slope r3, r0
        mov     r3, (sp)+
        .endc
        mov     r0, (sp)+
        .endm

        .macro  digest_side side
side'_record:
        mov     (r5), r2
        mov     at_x(r5), (sp)+
        mov     r2, (sp)+
        mov     at_z(r5), (sp)+
        mov     at_shade(r5), (sp)+
        cmp     r2, digest_lowest
        ble     side'_digested
        next_on_'side
        sub     (r4), r2
        ble     side'_level
        digest_slope at_x
        digest_slope at_z
        digest_slope at_shade
        mov     r4, r5
        jmp     side'_record
side'_level:
        add     #3*value_size, sp       ; no slope: the side leaves this vertex at once
        mov     r4, r5
        jmp     side'_record
side'_digested:
        .endm
