; SPDX-License-Identifier: MIT
; The renderers' lane memory and data formats; every file of programs/vliw includes this one. Word addresses of the fast memory.
; Who fills what: H the host, before the run (or a scanline at a time: the matrix); G geometry; C communication; R rasterising.
;
; The screen. At most 768 columns and 512 rows; rows of renderers that have frame buffers: a multiple of 64
        .iif ndf screen_columns, screen_columns = 768
        .iif ndf screen_rows, screen_rows = 512
        .if lt 768-screen_columns!<screen_columns-1>
        .error  screen_columns must be 1 to 768
        .endc
        .if lt 512-screen_rows!<screen_rows-1>
        .error  screen_rows must be 1 to 512
        .endc
;
        .iif ndf sort_first, sort_first = 0     ; 1: polygons go to the lanes of their columns first, geometry is done there
        .iif ndf boxes, boxes = 0               ; 1: there are no polygons, but descriptors to be sent: the host fills that array for each frame
        .if ne sort_first&boxes
        .error  bounding boxes are no scene for sort-first, which sends polygons before their geometry
        .endc
;
; Phases, by which work is counted: 0 other, 1 geometry, 2 communication, 3 normalising, 4 rasterising, 5 bringing pixels together, 6 migration.
;
; The lane and its share of the screen (H)
lane        = 0x00      ; this lane's number
column      = 0x01      ; the column of the screen that it draws; 0x7fff: none. Sort-middle: lane i draws column i, or none
polygons    = 0x02      ; polygons in this lane's database; sort-first keeps it right when they migrate
polygons_at = 0x03      ; where its database begins: kDatabase words each
source_at   = 0x04      ; where its array of descriptors to be sent begins; geometry works in it, too, before it makes them
source_end  = 0x05      ; first word behind that
receive_at  = 0x06      ; sort-first: where what is received lies; otherwise it is behind what is sent
receive_end = 0x07      ; first word behind that: room for one more than the lane keeps; sort-first receives polygons, kHome words each, and
                        ; the source array has the descriptors of what the lane draws
most        = 0x08      ; the greatest number of polygons on any lane (the same on all; sort-first finds it)
error       = 0x09      ; 0, or why the program halted: error_name_* below
lanes       = 0x0a      ; lanes on the ring, modulo 65536 (the same on all)
most_lanes  = 32767     ; ... at most: what counts them is a signed word, unless a program says otherwise
homes_end   = 0x0b      ; sort-first: first word behind the room for the database, one polygon more than the lane may ever hold
;
; What the machine's records call phases (`phase n`) and what `error` says
phase_name_finish = 0
phase_name_geometry = 1
phase_name_communicate = 2
phase_name_normalise = 3
phase_name_rasterise = 4
phase_name_composite = 5
phase_name_migrate = 6
error_name_the_source_array_is_full = 1
error_name_the_receive_array_is_full = 2
error_name_the_lanes_are_no_multiple_of_the_group = 3
error_name_there_is_no_room_for_the_composited_picture = 4
error_name_there_are_more_polygons_than_homes = 5
;
; The view (H). x' = (m0 x + m1 y + m2 z) / 2^14 + m9, and so on: eye space, x right, y up, z away; visible from near on.
; Screen, in 1/16 pixel: sx = 8 screen_columns + f x'/z', sy = 8 screen_rows - f y'/z'; samples lie on whole pixels, row 0 is the upper one.
; Nothing is clipped: a polygon is not visible when a vertex is nearer than near or about as far from the axis as from the viewer
; (|x'| or |y'| from 0.999 z' on: 700 pixels from the middle), or when a coordinate has no room in a word.
matrix      = 0x10      ; m0 ... m8 s1.14, m9 ... m11 integers
focal       = 0x1c      ; f, in 1/16 pixel: 11200; less than 16384
near        = 0x1d      ; 4097: smallest z' of a visible vertex, by the range of the reciprocals
;
; Lights, all white (H). Intensities add up and end at 255.
; A light at l (unit) gives a vertex with normal n, where n.l > 0: diffuse (n.l) + specular max(0, r.v)^(2^shininess),
; r = 2 (n.l) n - l, v = (0, 0, -1): the viewer is far away. So r.v = lz - 2 (n.l) nz.
ambient     = 0x20      ; 0 ... 255
sun         = 0x21      ; 3 words: unit vector towards the directional light, eye space, s1.14
sun_diffuse = 0x24      ; intensity times diffuse coefficient, 0 ... 255
sun_specular = 0x25     ; intensity times specular coefficient, 0 ... 255
lamp        = 0x26      ; 3 words: place of the point light, eye space, integers
lamp_diffuse = 0x29
lamp_specular = 0x2a
shininess   = 0x2b      ; the specular cosine is squared so many times: 0 ... 6
;
; Queues (G, C, R)
source_count  = 0x30    ; descriptors to be sent (geometry sets it: no need to clear it)
receive_count = 0x31    ; descriptors received
drawing     = 0x32      ; word address of the frame buffer being drawn
shown       = 0x33      ; of the one being shown; after `frame`: of the picture just finished
received_at = 0x34      ; where the received descriptors lie: behind those to be sent, with strides at the end of the room
received_end = 0x35     ; first word behind them
far_passes  = 0x36      ; passes of `stride` places in this frame, if stride is more than 1: lower word, upper word (the same on all lanes)
near_passes = 0x38      ; passes of 1 place
pixel_passes = 0x3b     ; passes of pixels, lower and upper word: composite.s, fragments.s
migration_passes = 0x3d ; passes of migrating polygons, lower and upper word: migrate.s
most_homes  = 0x3f      ; the most polygons that this lane has held at the end of a migration
scanline    = 0x3a      ; number of the next scanline, 0 ... scanlines - 1 (line-locked)
;
geometry_scratch = 0x40 ; 0x40 ... 0x9f
other_scratch = 0xa0    ; 0xa0 ... 0xff: communication, rasterising
frame_buffers = 0x100   ; two of 512 rows of 3 words: see pixel
roots       = 0x0d00    ; inverse square roots (H): roots + (m - 128), m = 128 ... 511: round(2^18 / sqrt(2 m)), at most 0x4000
scratch_end = 0x1000    ; databases and queues lie from here to 0x7fff
reciprocals = 0x8000    ; (H) reciprocals + z, z = 0 ... 32767: min(round(2^28 / z), 65535)
;
; A polygon of the database: counter-clockwise triangle as seen from the front (Eldridge 1995, figure 7-5)
kPolygon    = 24        ; words
kHome       = 27        ; words that a polygon has where its lane is to know more about it: homes.s
        .if ne sort_first
kDatabase   = kHome     ; from one polygon to the next
        .else
kDatabase   = kPolygon
        .endc
;   vertex v at 7 v: x, y, z integers; nx, ny, nz s1.14; u, v: two bytes (u the upper), 0.8
;   21: red, green bytes; 22: blue byte, texture's upper byte; 23: texture's lower bytes (0: no texture)
;
; A polygon descriptor (figure 7-6). Edges: E = A x + B y + C, x and y whole pixels, A and B in 1/16 pixel, C the floor of 1/16 of the
; exact value; a sample is inside where all three E >= 0 (so its sign is exact). Parameters p(x, y) = A x + B y + C, slopes s15.16, values
; 16.16 without a sign, all modulo 2^32, slopes steeper than their words, too: depth is 2^28 / z' (greater is nearer), u and v are u (0 ... 255)
; times depth / 256. At the vertices they are right to half a unit: u and v are rounded down, then C has half a unit more. Intensity: A, B
; s7.8, C s15.16, 0 ... 255, and half a unit added to C: so its whole part is rounded, and inside the triangle it is never below 0 nor above
; 255 as far as 256 pixels from vertex 0, across and down together.
; Slopes are 0 where the triangle's area is less than 1/16 pixel, those of intensity also where one of the two has no room in its
; word: then it is the mean of the vertices'.
kDescriptor = 42        ; words; 32-bit values: lower word first
d_left      = 0         ; columns and rows, whole pixels, within the screen: ceil of the least, floor of the greatest
d_right     = 1
d_top       = 2
d_bottom    = 3
d_passes    = 4         ; the communication's own: what it still has to do with this descriptor
d_colour    = 5         ; red, green; then blue, texture; then texture, as in the database
d_edges     = 8         ; three of: A, B, C (two words); from vertex 0 to 1, 1 to 2, 2 to 0
d_depth     = 20        ; A, B, C two words each
d_intensity = 26        ; A, B one word each, C two words
d_u         = 30        ; A, B, C two words each
d_v         = 36
;
; The same normalised to a lane's column, in place (R): an interpolant has a step from row to row and a value at row d_top, 32 bits each.
n_red       = 0         ; colours times 257
n_green     = 1
n_begin     = 2         ; word of the column's frame buffer where row d_top begins
n_end       = 3         ; ... where the row below d_bottom begins
n_blue      = 4
n_texture   = 5         ; not 0: textured
n_edges     = 8         ; three of: step, value
n_depth     = 22        ; step, value
n_intensity = 26        ; step, value; 64 times (the intensity less 255), without the half unit
n_u         = 32        ; step, value plus kUBias, which keeps rounding's -0 from being a great number
n_v         = 38
kUBias      = 128       ; whole units
;
; The texture (H): 128 x 128 texels in slow bank 0, the one of column i and row j at j 256 + i, for u = 2 i and v = 2 j; it repeats, so column 128
; and row 128 are copies of column 0 and row 0. A texel: 5 bits red, 6 green, 5 blue. Polygons with any texture but 0 have this one.
;
; A pixel: 3 words. 0: depth, whole part (0: nothing drawn); 1: depth's fraction, upper byte; red; 2: green, blue.
; Renderers by regions have it elsewhere, a word in each of three banks, and the finished picture spread over the lanes: region.s, composite.s.
kPixel      = 3
