; SPDX-License-Identifier: MIT
; Memory: what the loader writes for this processor, tables, and the polygon in hand.

; ---- constants of this processor; the loader fills everything from here to parameters_end
        .even
parameters:
background:     .word   0               ; shade, s8.7, of a pixel without a polygon
x_step:         .word   1               ; pixels from one column of the grid to the next
x_shift:        .word   0               ; its logarithm to base 2, or -1 when it is no power of 2
y_step:         .word   1               ; lines from one row to the next, likewise
y_shift:        .word   0

; Tables by coordinate, and their limits: a screen of at most max_size x max_size
max_size = 1024.
; [x], x = 0 to width: address of the depth word of the first assigned pixel that is not left of x; behind the last
; column when there is none
first_pixel:    .blkw   max_size+1
; [x]: 0 when pixel x is assigned and x_step is 1; else 1 more than the distance from x to that pixel
lead_at:        .blkw   max_size
; row_at [y], y = -1 to height - 1: the highest row that is not above y, -1 when there is none. row_below [y] is the
; highest one below y
row_below:      .blkw   max_size+1
row_at = row_below+2
; [y]: 0 when line y is assigned and y_step is 1; else 1 more than the distance from y down to that row's line
lag_at:         .blkw   max_size
; [row]: its y
line_of:        .blkw   max_size
parameters_end:

; ---- the message in hand: a polygon as the host sent it, or digested
        .if ne full
value_size = 4
        .iff
value_size = 2
        .endc
record_size = 10+<3*value_size>         ; of a digested polygon's vertex: x, y, z, shade, their slopes down its edge
        .if ne full
digest_header = 12
        .iff
digest_header = 10
        .endc
longest_message = digest_header+<14.*record_size>+<2*10>

message:        .blkb   2               ; kind, hops
vertex_count:   .blkw   1               ; 0: the frame ends
vertices:                               ; x, y, z, shade each
message_right:  .blkw   1               ; digested: from `message` to the first record of the right side
message_lowest: .blkw   1               ; the lowest row
        .if ne full
message_highest: .blkw  1               ; the highest row
        .endc
message_records:                        ; of the left side
                .blkb   longest_message-<.-message>
; Places of a vertex' words, from its y: pointers to vertices hold the address of y.
at_x = -2
at_z = 2
at_shade = 4
vertex_size = 10
first_y = vertices-at_x                 ; of the first vertex
message_left = message_records-at_x     ; of the first record
slope_of_at_x     = 6                   ; likewise, in a record
slope_of_at_z     = 6+value_size
slope_of_at_shade = 6+<2*value_size>
vertices_end:   .blkw   1               ; first_y of one behind the last

; ---- its progress
row:            .blkw   1               ; of the present line
end_row:        .blkw   1               ; the row below the polygon's last one
lines:          .blkw   1               ; to be drawn, from the present one, until a side comes to its next vertex
left_next:      .blkw   1               ; the lower vertex of the left side's edge
right_next:     .blkw   1
left_row:       .blkw   1               ; the highest row that is not above it
right_row:      .blkw   1

; ---- its sides on the present line, and what is added from line to line. Full precision: 32 bits, high word first, 16 of them
; fraction. The words are used from the last to the first, because -(r) costs a cycle less than (r)+ and X(r).
left_x:         .blkb   value_size
left_z:         .blkb   value_size
left_shade:     .blkb   value_size
left_end:
right_x:        .blkb   value_size
right_z:        .blkb   value_size
right_shade:    .blkb   value_size
right_end:
left_deltas:    .blkb   3*value_size
left_deltas_end:
right_deltas:   .blkb   3*value_size
right_deltas_end:
to_delta = left_deltas-left_x           ; from a value to its delta

; ---- the present segment: what is added from pixel to pixel
pixel_dz:       .blkw   2
pixel_dshade:   .blkw   1
run_entry:      .blkw   1               ; of a long run of pixels: where its first round begins
run_end:        .blkw   1               ; the depth word behind its last pixel

; ---- temporaries
lag:            .blkw   1               ; from a vertex down to the present line
lead:           .blkw   1               ; from a segment's left end to its first assigned pixel
whole:          .blkw   1               ; a slope's parts
steps:          .blkw   1               ; what a difference is divided by
start_z:        .blkw   2               ; at that pixel
start_shade:    .blkw   2

; ---- the polygon that is being digested: a message
        .if ne half_digested
digest_port = ports_base+port_size
digest_room = 2                         ; its bit in TXROOM
digest:         .byte   3, 0
digest_vertices: .blkw  1
digest_right:   .blkw   1
digest_lowest:  .blkw   1
        .if ne full
digest_highest: .blkw   1
        .endc
digest_left:    .blkb   28.*record_size ; twice what a convex polygon needs; TXLEN refuses what is too long
digest_top:     .blkw   1               ; of the right side
        .endc
