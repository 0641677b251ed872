; SPDX-License-Identifier: MIT
; The numbers by which the program tells the machine what it does and why it gives up.

; what the processor does, as MARK tells the statistics
mark_start    = 0
mark_rotate   = 1
mark_points   = 2
mark_assemble = 3
mark_route    = 4
mark_scan     = 5
mark_span     = 6
mark_clear    = 7

; why the program gives up, as FAULT shows it
fault_pool    = 1               ; every message block is kept: the node holds more facets and points than fit
fault_points  = 2               ; more facets in reach than the table of points holds
fault_pending = 3               ; more triangles wait for points than their table holds
fault_missing = 4               ; a vertex of a triangle is nowhere in reach
fault_message = 5               ; a message of an unknown kind
