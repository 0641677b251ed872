; SPDX-License-Identifier: MIT
; Rotation and display of an object by a sphere of processors (T. Strothotte 1981, chapter 5), one copy on each processor.
;
; A frame is six phases which the processor supervisor separates; between them nothing is in flight:
;   0 ROTATE    facets move to the processors that stand where they point now        rotate.s
;   1 POINTS    place and intensity of every crossing, sent to the neighbours        points.s
;   2 ASSEMBLE  triangles from own and received points; missing points are asked     assemble.s, request.s
;   3 SEEK      points still missing are looked for farther away                     request.s
;   4 TRANSFER  triangles travel to the owner of the pixel at their centre           transfer.s
;   5 DRAW      scan conversion, hand-over of scanline parts, z-buffer               scan.s, span*.s
; docs/geodesic-program.md explains the whole; layout.s has the memory, the formats and the messages.

phases_per_frame = 6
; as statistics name them
phase_name_rotate   = 0
phase_name_points   = 1
phase_name_assemble = 2
phase_name_seek     = 3
phase_name_transfer = 4
phase_name_draw     = 5

        .include "include/node.s"
        .include "strothotte/codes.s"
        .include "strothotte/macros.s"
        .include "strothotte/layout.s"

        . = code_base
        .include "strothotte/main.s"
        .include "strothotte/pool.s"
        .include "strothotte/receive.s"
        .include "strothotte/rotate.s"
        .include "strothotte/angles.s"
        .include "strothotte/points.s"
        .include "strothotte/exchange.s"
        .include "strothotte/assemble.s"
        .include "strothotte/request.s"
        .include "strothotte/route.s"
        .include "strothotte/transfer.s"
        .include "strothotte/walk.s"
        .include "strothotte/scan.s"
        .include "strothotte/edge.s"
        .include "strothotte/span_make.s"
        .include "strothotte/span.s"
        .include "strothotte/data.s"
        .include "strothotte/sine.s"
        .even
free_memory:                            ; the loader's tables, the pixels and the message pool follow

        .end start
