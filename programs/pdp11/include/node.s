; SPDX-License-Identifier: MIT
; The node's registers (programs/README.md), for every program.

; a port's registers, from its base at 164000 + 20 k
txstat = 0
txaddr = 2
txlen  = 4
rxstat = 10
rxlen  = 12
rxaddr = 14
ports_base = 164000
port_size = 20                  ; from one port's registers to the next one's
tx_room_bit = 200
rx_waits_bit = 200

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

; conditions of WAITFOR
wait_message = 100000           ; a message waits at some port
wait_phase   = 040000           ; PHASE is not what it was when last read
