; SPDX-License-Identifier: MIT
; Memory, messages and records.
;
; Memory
;   000000  vectors, all zero: a trap ends the run with a report
;   000400  stack, down from stack_top
;   001000  code, variables and constants of the program (data.s); the loader fills the constants
;           the loader's tables and the pixels, where it likes behind free_memory
;           the message pool, to the end of memory
;
; Formats
;   s1.14   direction, normal, radius, scaled coordinates: 16384 is 1
;   s9.6    place on the screen in 1/64 pixel, x to the right, y down
;   s2.13   depth, smaller is nearer
;   7.7     intensity: 128 is a grey level; bit 15 of a point's intensity: the surface looks away from the viewer
;   angle   65536 is a full turn, theta 0 to 32768 from the north pole

stack_top = 1000
code_base = 1000

; Block of the message pool. A pointer to a block points at its message, byte 0.
b_link   = -4                   ; the next block of the list this one is on, or 0
b_length = -2                   ; bytes of the message

; All messages: kind and hops, which the receiver counts up
m_kind = 0
m_hops = 1
kind_facet    = 1
kind_points   = 2
kind_request  = 3
kind_reply    = 4
kind_triangle = 5
kind_span     = 6

; FACET: a facet with all its crossings, at home in its processor or on its way. 18 + 8 crossings + 6 triangles bytes
f_id     = 2                    ; number of the facet: that of the processor it began at
f_phi    = 4                    ; angle, virtual longitude where it points now
f_theta  = 6                    ; angle, virtual colatitude
f_sin    = 10                   ; s1.14, sine and
f_cos    = 12                   ; cosine of theta
f_cross  = 14                   ; byte, number of crossings, 1 to 8
f_tris   = 15                   ; byte, number of triangles it is responsible for
f_x      = 16                   ; s1.14, virtual direction for great-circle routing; its z is f_cos
f_y      = 20
f_body   = 22                   ; crossings, then triangles
; a crossing: radius, normal along the virtual cylinder's radius, phi and axis: four words s1.14, unchanged by rotation
; a triangle: facet of the second and of the third corner, then crossing numbers: first corner (of this facet)
; in bits 3 to 5, second in bits 6 to 8, third in bits 9 to 11

; POINTS and REPLY: the crossings of a facet as the screen shows them. 8 + 8 points bytes
p_id     = 2                    ; number of the facet
p_count  = 4                    ; byte, number of points
p_depth  = 5                    ; byte, hops still to go back (REPLY)
p_path   = 6                    ; their ports, 4 bits each, next one lowest
p_body   = 10                   ; points
; a point: x, y (s9.6), depth (s2.13), intensity (7.7 and bit 15)

; REQUEST: who has this facet's points? 10 bytes
q_id     = 2                    ; number of the facet
q_left   = 4                    ; byte, hops it may still go on
q_depth  = 5                    ; byte, hops it came
q_path   = 6                    ; the ports back, 4 bits each, last one lowest
q_origin = 10                   ; node that asks
q_size   = 10.

; TRIANGLE: 34 bytes, 40 with great-circle routing
t_path   = 2                    ; ports still to walk, 3 bits each, next one lowest, then ones; 0: routed by angles
t_x      = 4                    ; byte, pixel it goes to: that at its centre
t_y      = 5                    ; byte
t_phi    = 6                    ; angle, the same as coordinates on the sphere
t_theta  = 10
t_body   = 12                   ; three points, bit 15 of the intensity clear
t_vx     = 42                   ; s1.14, the same as a direction
t_vy     = 44
t_vz     = 46
t_size_small = 34.
t_size_great = 40.

; SPAN: a run of pixels on a scanline. 20 bytes
s_path   = 2                    ; as t_path, never 0
s_y      = 4                    ; byte, row
s_first  = 5                    ; byte, first column
s_last   = 6                    ; byte, last column
s_z      = 10                   ; depth at the first pixel's centre: s2.13 and 16 bits of fraction
s_dz     = 14                   ; its growth a pixel, the same
s_i      = 20                   ; intensity at the first pixel's centre in 8.8: 256 is a grey level; rounding is added
s_di     = 22                   ; its growth a pixel, modulo 65536
s_size   = 20.

; Row of the processor's part of the screen: 16 bytes
w_first  = 0                    ; columns it owns on this row,
w_last   = 2                    ; last < first: none
w_length = 4                    ; how many
w_z      = 6                    ; address of the first pixel's depth word
w_grey   = 10                   ; and of its grey byte
w_left   = 12                   ; path to the owner of the pixels to the left
w_right  = 14                   ; and to the right

; Node's routing record: see route.s
