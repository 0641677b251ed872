; SPDX-License-Identifier: MIT
; The tiler: draws convex polygons of 1 to 14 vertices, and parts of such, depth-buffered and with interpolated shade, on the
; grid of pixels that one processor of Parks' machines owns (Parks 1982, chapter 2). One source serves all machines and both precisions;
; docs/tiler-program.md explains it and says what it costs.
;
; What is drawn: machine/host/polygon_renderer.hpp states the rule, bit for bit. Formats of polygons and messages:
; machine/fabric/polygon.hpp. Symbols that choose the program, set before assembly:
;   full              1: slopes with 15 bits of fraction, and parts of polygons (default). 0: whole numbers, as in the thesis'
;                     listing; splitters cut polygons
;   skip_deltas       1: no division for a slope that nothing will use, or that is 0. 0: always divide (default)
;   frame_buffer_bus  1: the image is written over the frame-buffer bus. 0: in memory (default)
;   half_digested     1: polygons are set up by one processor each, which broadcasts them to the others. 0: by all (default)
;
; How it goes. A polygon's vertices are looked through once for the highest and the lowest. Its left side then runs downwards
; through the vertices as they follow each other, its right side against their order. A side stands on an edge, with x, z
; and shade as they are on the present line and what to add for the next line. Lines are counted by their row in the
; processor's grid: a table has the highest row not above a vertex, so that a side comes to a new edge when its lower vertex'
; row is reached. Between such events the inner loop draws one segment a line.
;
; Registers have no fixed use. There is no stack: sp is a register like any other, since no interrupt is ever enabled and no
; routine is called. Numbers are octal, decimal with a point.
;
; For statistics, labels tell where a section of the work begins; it ends where the next one begins.
;   tap_idle*         the next instruction waits for a message
;   tap_digest*       a polygon is worked out for all; only where there is half-digested broadcast
;   tap_polygon*      a polygon is set up; `vertex_count` has its number of vertices
;   tap_vertex*       a side comes to its next vertex, and to the edge below it
;   tap_segment*      a line of the polygon is begun; `row` has its row
;   tap_pixels*       its pixels are drawn next: sp of them (1 or more), the first one's depth word at r5, so in column
;                     (r5 - depth_window) / 2; `row` has the row still
;   tap_pixels_done*  the segment's tail. A segment without an assigned pixel comes here straight from tap_segment: length 0

        .ifndf  full
full = 1
        .endc
        .ifndf  skip_deltas
skip_deltas = 0
        .endc

        .ifndf  half_digested
half_digested = 0
        .endc

        .if ne full
takes_parts = 1                         ; the machine's splitters then leave edges whole
        .endc

phases_per_frame = 1
phase_name_draw  = 0

        .include "include/node.s"
        .include "include/frame_buffer.s"
        .include "tiler/slope.s"
        .include "tiler/neighbour.s"
        .if ne full
        .include "tiler/part.s"
        .endc
        .if ne half_digested
        .include "tiler/digest_side.s"
        .endc

        . = 1000

; The host has no more polygons. When nobody has anything left the supervisor announces the next frame, or the end.
end_of_frame:
        mov     #-1, @#io_credit
        mov     #wait_phase, @#io_waitfor
        mov     @#io_phase, r0
        inc     r0                      ; 177777 when all is over
        bne     clear_frame
finish: halt

start:  tst     @#io_phase              ; so that WAITFOR knows which one it is
clear_frame:
        mov     background, @#io_fbclear

        .ifeq   half_digested
tap_idle:
next_polygon:
        mov     #message, @#ports_base+rxaddr   ; holds until a message is there
        mov     vertex_count, r1
        beq     end_of_frame
        .if ne full
        bmi     begin_part
        .endc
        .else
        .include "tiler/digest.s"
        .endc

begin_polygon:
        .include "tiler/polygon.s"
        .include "tiler/segment.s"
        .if ne full
        .include "tiler/long_run.s"
        .endc
        .include "tiler/lead.s"
        .include "tiler/edge.s"

        .include "tiler/parameters.s"

        .end start
