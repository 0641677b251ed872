; SPDX-License-Identifier: MIT
; One side of a polygon as records, from its top vertex (at r5) to its first lowest one; sp is where the next record goes.

; Clobbers r0, r1, r3.
        .macro  digest_slope at
        mov     at(r4), r1
        sub     at(r5), r1
        divide  r2, r3, shift_of_'at
        .if ne full
        join_slope r3, r0
        mov     r3, (sp)+
        .endc
        mov     r0, (sp)+
        .endm

        .if ne full
; The change from a to the line L = r3 below it, on an edge that is D = r2 < 32 high.
        .macro  digest_change at
        short_change at, r3
        mov     r0, (sp)+
        clr     (sp)+
        .endm
        .endc

        .macro  digest_side side
side'_record:
        mov     (r5), r2
        mov     at_x(r5), (sp)+
        mov     r2, (sp)+
        mov     at_z(r5), (sp)+
        mov     at_shade(r5), (sp)+
        cmp     r2, digest_lowest
        beq     side'_digested
        next_on_'side
        sub     (r4), r2
        ble     side'_level
        .if ne full
        cmp     r2, #subpixels
        blt     side'_short
        .endc
        digest_slope at_x
        digest_slope at_z
        digest_slope at_shade
        mov     r4, r5
        jmp     side'_record
        .if ne full
; Less than a line high: the changes down to the line, if one crosses it below a.
side'_short:
        mov     (r5), r3
        bic     #-subpixels, r3
        cmp     r3, r2
        bge     side'_level
        digest_change at_x
        digest_change at_z
        digest_change at_shade
        mov     r4, r5
        jmp     side'_record
        .endc
side'_level:
        add     #3*value_size, sp       ; no slope: the side leaves this vertex at once
        mov     r4, r5
        jmp     side'_record
side'_digested:
        .endm
