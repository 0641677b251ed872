; SPDX-License-Identifier: MIT
; The bucket renderer: draws the triangles that overlap a tile of the screen, depth-buffered, shaded and perhaps textured, on
; the pixels of that tile, which the processor's frame buffer holds; tile after tile, as the tile sorter sends them
; (Chen and others 1998, software rasterizers).
;
; What is drawn: machine/host/tile_renderer.hpp and triangle_planes.hpp state the rule, bit for bit; names of values are theirs.
; Symbols that choose the program, set before assembly:
;   textured  1: a texel times the shade. 0: the shade (default)
;
; Messages come at port 0. Words, low byte first; coordinates are signed, y downwards:
;   byte 0 kind, byte 1 hops, word 1: 1 triangle, 0 end of the frame, -1 tile
;   triangle: 3 times x, y (1/16 pixel), depth (0 to 32766), shade (grey level times 128), u, v (1/65536 of the texture, unsigned)
;   tile: left, top, right, bottom in pixels, both ends included, 1024 columns at most
; A tile takes the place of the one before, which is finished then: FBCLEAR hands it over. What is read at that moment is
; tile_left, tile_top, tile_right and tile_bottom; there is none with tile_right below tile_left, as between frames.
; Triangles are fronts, with vertices at most 2047 pixels from the screen's corner and from each other each way.
;
; How it goes. The vertices are T, M and B from the highest to the lowest. The long edge T-B is one side of the triangle, T-M
; and M-B are the other. Each side's first or last covered column is carried from line to line exactly: a whole number and
; a remainder. Lines above the tile are left out by setting the sides up for its top line; columns beside it by cutting a
; line's run of pixels; a triangle that an edge shows to be beside the tile is dropped. The first line with a pixel in the tile sets up what depth, shade, u and v are there and how
; they change with column and line, once a triangle.
;
; Registers have no fixed use. There is no stack: sp is a register like any other, since no interrupt is ever enabled and no
; routine is called. Numbers are octal, decimal with a point.
;
; For statistics, labels tell where a section of the work begins; it ends where the next one begins.
;   tap_idle*         the next instruction waits for a message, but behind a tile
;   tap_polygon*      a triangle is set up; `vertex_count` has its number of vertices
;   tap_vertex*       an edge is set up, or the planes
;   tap_segment*      a line of the triangle is begun; `row` has its row
;   tap_pixels*       its pixels are drawn next: sp of them (1 or more), the first one's depth word at r5, so in column
;                     (r5 - depth_window) / 2; `row` has the row still
;   tap_pixels_done*  the line's tail. A line without a pixel in the tile has none of the two: length 0

        .ifndf  textured
textured = 0
        .endc

phases_per_frame = 1
phase_name_draw  = 0

        .include "include/node.s"
        .include "include/frame_buffer.s"

        . = 1000

; The host has no more triangles. When nobody has anything left the supervisor announces the next frame, or the end.
end_of_frame:
        mov     background, @#io_fbclear
        clr     tile_left
        mov     #-1, tile_right
        mov     #-1, @#io_credit
        mov     #wait_phase, @#io_waitfor
        mov     @#io_phase, r0
        inc     r0                      ; 177777 when all is over
        bne     next_triangle
finish: halt

new_tile:
        mov     background, @#io_fbclear
        mov     #message_tile, r0
        mov     (r0)+, tile_left
        mov     (r0)+, tile_top
        mov     (r0)+, r1
        mov     r1, tile_right
        sub     tile_left, r1
        mov     r1, last_column
        mov     (r0), tile_bottom
        mov     #message, @#ports_base+rxaddr
        br      look

start:  tst     @#io_phase              ; so that WAITFOR knows which one it is
tap_idle:
next_triangle:
        mov     #message, @#ports_base+rxaddr   ; holds until a message is there
look:   mov     message_sign, r0
        beq     end_of_frame
        bmi     new_tile

        .include "bucket/edge.s"
        .include "bucket/triangle.s"
        .include "bucket/line.s"
        .include "bucket/planes.s"
        .include "bucket/memory.s"

        .end start
