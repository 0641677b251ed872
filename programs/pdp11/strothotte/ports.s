; SPDX-License-Identifier: MIT
; The node's registers (programs/README.md).

; a port's registers, from its base at 164000 + 20 k
txstat = 0
txaddr = 2
txlen  = 4
rxlen  = 12
rxaddr = 14
ports_base = 164000
tx_room_bit = 200

; the node's own
io_node    = 165000
io_ports   = 165002
io_rxany   = 165004
io_waitfor = 165006
io_txroom  = 165010
io_credit  = 165012
io_phase   = 165014
io_mark    = 165016
io_fault   = 165020

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
