; SPDX-License-Identifier: MIT
; r4 = the vertex after the one at r5, on that side, in the polygon as the host sent it.

        .macro  next_on_left ?no_wrap
        mov     r5, r4
        add     #vertex_size, r4
        cmp     r4, vertices_end
        blo     no_wrap
        mov     #first_y, r4
no_wrap:
        .endm

        .macro  next_on_right ?no_wrap
        mov     r5, r4
        sub     #vertex_size, r4
        cmp     r4, #first_y
        bhis    no_wrap
        mov     vertices_end, r4
        sub     #vertex_size, r4
no_wrap:
        .endm
