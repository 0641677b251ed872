; SPDX-License-Identifier: MIT
; Parts of polygons, in full precision: what splitters leave of a polygon has whole edges and is drawn on some of its rows only
; (machine/fabric/polygon_part.hpp). So its sides begin somewhere down an edge, as they do in an interlace, and end before the
; lowest vertex.

; In: a part in `message`, vertices_end. Out: its highest and lowest row.
        .macro  part_rows highest, lowest
        mov     vertices_end, lowest
        mov     at_x(lowest), highest
        mov     (lowest), lowest
        .endm

; In: r3 the first row, r4 the one below the last. Each side is to look down from its first vertex for the edge that crosses
; that row: as if they were late for the vertex, which is above it.
        .macro  begin_between
        mov     r4, end_row
        mov     r3, row
        inc     r3
        mov     r3, right_row
        .endm
