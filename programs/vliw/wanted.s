; SPDX-License-Identifier: MIT
; The list of what a lane draws, in slow bank 0 behind the texture: the addresses of descriptors (communicate_region.s) or polygons (distribute.s).
; communicate.s has there what a lane sends in a round.

wanted      = 0x8200
wanted_end  = other_scratch+57          ; behind the last of `wanted`

list        = r15                       ; wanted_end

; A list begins. r10: spoilt.
        .macro  begin_list at, end
        mov     r10, #at
        st      r10, end
        .endm

; What has come and is kept (r16: 1) is listed.
        .macro  list_it
        sts     into, 0, (list)
        add     list, list, r16
        .endm
