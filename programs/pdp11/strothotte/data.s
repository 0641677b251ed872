; SPDX-License-Identifier: MIT
; The program's memory: first what the loader fills, by name, then what the program keeps.

        .even
; Filled by the loader
phase_count:    .word   phases_per_frame
port_count:     .word   0               ; of this processor
last_port:      .word   0               ; twice the highest port's number
great_circle:   .word   0               ; 0: small-circle routing
pool_next:      .word   0               ; the message pool: the first block never used,
pool_last:      .word   0               ; the last one,
free_count:     .word   0               ; how many are free in all
block_size:     .word   0               ; bytes of a block, with its 4 in front of the message
triangle_size:  .word   t_size_small    ; bytes of a TRIANGLE
facet_list:     .word   0               ; FACET blocks this processor holds, made by the loader outside the pool
virtual_route:  .word   0               ; routing records
screen_route:   .word   0
turn_step:      .word   0, 0            ; the next frame's turn, angle and 16 bits of fraction
turn_next:      .word   0, 0            ; that of all later frames
; the screen
screen_width:   .word   0
screen_height:  .word   0
last_column:    .word   0
last_row:       .word   0
column_angle:   .word   0               ; longitude of a pixel's width
half_column_angle: .word 0
row_angle:      .word   0               ; colatitude of a pixel's height
half_row_angle: .word   0
depth_start:    .word   0               ; this processor's depths, a word each,
depth_groups:   .word   0               ; in groups of eight words
grey_start:     .word   0               ; and grey levels, a byte each
grey_groups:    .word   0
background:     .word   0               ; grey level in both bytes
row_table:      .word   0               ; its rows (w_), from top_row down
row_count:      .word   0
top_row:        .word   0
path_up:        .word   0               ; towards rows above
path_down:      .word   0               ; towards rows below; towards the screen if it owns no pixel
; the view: axes in half-widths and half-heights of a screen of 256 pixels, s1.14, in virtual cylinder coordinates at
; this processor's longitude
here_phi:       .word   0
right_rho:      .word   0
right_phi:      .word   0
right_z:        .word   0
down_rho:       .word   0
down_phi:       .word   0
down_z:         .word   0
away_rho:       .word   0
away_phi:       .word   0
away_z:         .word   0
light_rho:      .word   0               ; unit vector towards the light
light_phi:      .word   0
light_z:        .word   0
scale:          .word   0               ; s1.14
shift_right:    .word   0               ; translation, s1.14
shift_down:     .word   0
shift_away:     .word   0
divisor_shift:  .word   0               ; perspective: shrink = dividend / (divisor_base + (d shifted))
divisor_base:   .word   0
dividend:       .word   0, 0
shrink_shift:   .word   0               ; 15 less the bits of fraction of shrink
centre_x:       .word   0               ; s9.6
centre_y:       .word   0
ambient:        .word   0               ; 7.7
diffuse:        .word   0               ; 7.7, what the light adds at most

loader_end:

; Kept by the program
phase:          .word   0               ; as announced last
step:           .word   0               ; twice the number of the next phase within the frame
owed:           .word   0               ; 1: this phase's credit is still to be given back
arrival_port:   .word   0
free_list:      .word   0
queue_mask:     .word   0               ; bit k: messages wait for port k
turn_total:     .word   0, 100000       ; the half rounds
turned_by:      .word   0
angle:          .word   0
sine:           .word   0
cosine:         .word   0
facet:          .word   0
facet_away_rho: .word   0
facet_away_phi: .word   0
facet_light_rho: .word  0
facet_light_phi: .word  0
out_right:      .word   0               ; the facet's direction on the screen's axes
out_down:       .word   0
out_away:       .word   0
points_left:    .word   0
scaled_radius:  .word   0
distance:       .word   0
shrink:         .word   0
point_top:      .word   0
own_points:     .word   0
tris_left:      .word   0
corner1:        .word   0
sum_x:          .word   0
sum_y:          .word   0
out_list:       .word   0               ; triangles for TRANSFER
draw_list:      .word   0               ; triangles for DRAW
pending_top:    .word   0
request_hops:   .word   0
resumed:        .word   0
seen_next:      .word   0
goal_x:         .word   0
goal_y:         .word   0
goal_z:         .word   0
best:           .word   0, 0
best_port:      .word   0
port:           .word   0
scanning:       .word   0               ; the triangle being drawn
top_vertex:     .word   0
middle_vertex:  .word   0
low_vertex:     .word   0
lower_half:     .word   0
own_row:        .word   0               ; the current row, counted from top_row,
row_record:     .word   0               ; and its record where it is this processor's
steps_due:      .word   0               ; 0: the long edge stands at the short edge's first row already
rows_left:      .word   0               ; until the short edge ends
edge_first:     .word   0
edge_rows:      .word   0
skip:           .word   0
divisor:        .word   0
span_last:      .word   0
span_row:       .word   0
across:         .word   0               ; greatest width, and differences over it
across_z:       .word   0
across_i:       .word   0
steep:          .word   0
quick:          .word   0               ; 1: a pixel's growth is known
whole_z:        .word   0               ; that of the depth, rounded
                .word   0, s_size       ; the current row as a SPAN: growths for the whole triangle,
row_span:       .word   kind_span, 0, 0, 0 ; start for the row, columns and path only to hand it over
pixel_z = row_span + s_dz
pixel_i = row_span + s_di
                .blkw   6
long_edge:      .blkw   12.
short_edge:     .blkw   4

; Ports by twice their number
k = 0
port_address:
        .rept   8.
        .word   <ports_base + <20 * k>>
        k = k + 1
        .endr
port_bit:       .word   1, 2, 4, 10, 20, 40, 100, 200
queue_head:     .blkw   8.
queue_tail:     .blkw   8.

point_id:       .blkw   max_points + 1
point_block:    .blkw   max_points + 1
pending_facet:  .blkw   max_pending
pending_record: .blkw   max_pending
pending_points: .blkw   max_pending
seen_id:        .blkw   max_seen
seen_origin:    .blkw   max_seen
