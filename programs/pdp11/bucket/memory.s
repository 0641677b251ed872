; SPDX-License-Identifier: MIT
; Memory: what the loader writes, the tile, and the triangle in hand.

; ---- the loader fills everything from here to parameters_end
        .even
parameters:
background:     .word   0               ; image word, s8.7, of a pixel without a triangle
        .if ne textured
; Texels, a word each: 0 to 32767, what a shade is multiplied by for its half. A row has 400 bytes, 64 columns of them in use,
; then one that repeats the last of these, and the last one the first, for columns 64 and -1, where a cut-off value may
; fall; likewise the rows before and behind the 64.
texture_row = 400
        .blkb   texture_row             ; row -1
texture:        .blkb   65.*texture_row
        .endc
parameters_end:

; ---- the tile, in pixels of the screen, both ends included
tile_left:      .word   0
tile_top:       .word   0
tile_right:     .word   -1              ; none yet
tile_bottom:    .word   0
last_column:    .word   0               ; tile_right - tile_left

; ---- the message in hand
message:        .blkw   1               ; kind, hops
message_sign:   .blkw   1
message_tile:                           ; left, top, right, bottom
vertices:       .blkw   18.             ; x, y, depth, shade, u, v each
; Places of a vertex' words, from its y: pointers to vertices hold the address of y.
at_x = -2
at_depth = 2
at_shade = 4
at_u = 6
at_v = 10
vertex_size = 14
vertex_0 = vertices-at_x
vertex_1 = vertex_0+vertex_size
vertex_2 = vertex_1+vertex_size
vertex_count:   .word   3               ; of every triangle

; ---- its progress
top:            .blkw   1               ; T, M, B
middle:         .blkw   1
bottom:         .blkw   1
middle_is_left: .blkw   1               ; -1 or 0
first_line:     .blkw   1               ; the first line in the tile
line_16:        .blkw   1               ; y of the line on which an edge is set up, in 1/16 pixel
lines:          .blkw   1               ; behind the present one until the short side's edge ends
lines_below:    .blkw   1               ; likewise behind the first one of the edge after it
edge_ended:     .blkw   1               ; what to do then
row:            .blkw   1               ; the present line's, from the tile's top
column:         .blkw   1               ; to which the values belong, from the tile's left; -1: no planes yet

; ---- on the present line: the sides, and depth, shade, u and v at `column`; and what is added for the next line. The words
; are used from the last to the first, because -(r) costs a cycle less than (r)+ and X(r). A side: its first (last) covered
; column from the tile's left; how far the edge is from the next one, less what that takes, in 1/(the edge's height).
left_x:         .blkw   2
right_x:        .blkw   2
sides_end:
depth:          .blkw   2               ; 32 bits each, high word first, 16 of them fraction
shade:          .blkw   2
        .if ne textured
u:              .blkw   2
v:              .blkw   2
        .endc
values_end:

left_x_dy:      .blkw   2
right_x_dy:     .blkw   2
sides_dy_end:
depth_dy:       .blkw   2
shade_dy:       .blkw   2
        .if ne textured
u_dy:           .blkw   2
v_dy:           .blkw   2
        .endc
dys_end:
to_dy = depth_dy-depth                  ; from a value to what is added a line

; What is added for the next column: G x, and m, with which that is m times a power of two.
depth_dx:       .blkw   2
shade_dx:       .blkw   2
        .if ne textured
u_dx:           .blkw   2
v_dx:           .blkw   2
        .endc
dxs_end:
to_dx = depth_dx-depth

depth_m:        .blkw   2               ; the second word is not used
shade_m:        .blkw   2
        .if ne textured
u_m:            .blkw   2
v_m:            .blkw   2
        .endc
to_m = depth_m-depth

left_height:    .blkw   1               ; of the edge a side stands on, 1/16 pixel
right_height:   .blkw   1

; ---- temporaries of an edge
edge_x:         .blkw   1               ; its horizontal extent

; ---- temporaries of the planes
long_x:         .blkw   1               ; D
long_y:         .blkw   1               ; times -1 with M on the left
middle_y:       .blkw   1               ; E, likewise
area_15:        .blkw   1               ; A'
height_15:      .blkw   1               ; D'
precision:      .blkw   1               ; p
shift_n:        .blkw   1               ; k - 1, or so that nothing is left
shift_x:        .blkw   1               ; 20 - p
shift_x_16:     .blkw   1               ; less 4
shift_g:        .blkw   1               ; t when negative
shift_y:        .blkw   1               ; t when positive
shift_y_high:   .blkw   1               ; plus 11
shift_y_low:    .blkw   1               ; minus 4
from_x:         .blkw   1               ; from T to the pixel, 1/16 pixel
from_y:         .blkw   1
to_bottom:      .blkw   1               ; d
g_low:          .blkw   1               ; 15 bits
        .if ne textured

; ---- of the pixels being drawn
run_end:        .blkw   1               ; the depth word behind the last
run_shade:      .blkw   2
run_u_low:      .blkw   1
run_v_low:      .blkw   1
        .endc
program_end:
