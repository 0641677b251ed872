; SPDX-License-Identifier: MIT
; A lane's region of the screen (Eldridge 1995, 6.2). The screen's columns are divided into `group` regions; lane r + k group draws region r, as its
; k-th member. What several lanes have drawn of one region is composited (composite.s) or sent as fragments (fragments.s).
;
; A region is drawn in bands of `band_rows` rows, because it must fit into the slow memory: pixel
;     p = (x - region_left) band_rows + y - row_first
; has its words 0, 1 and 2 (memory.s) at address p of the banks 1, 2 and 3. Between bands all depths are 0: those who take a pixel out clear it.
; Where bands are composited all lanes have the same; where fragments are sent each begins its next one at the topmost row that it needs.

        .iif ndf group, group = 1               ; a divisor of lanes

; Bank 0, behind the texture: two lists of addresses of descriptors, then what is to be brought together (composite.s, fragments.s).
        .include "wanted.s"
banded      = 0x8500                            ; what of that meets the band
kGathered   = 0x8800
kGatheredEnd = 0x10000

        .if gt stride-1
        .error  stride is an option of sort-middle: a group is the distance here
        .endc
        .if df duplication
        .error  duplication is an option of sort-middle
        .endc
        .if lt 1023-group*<group-1>
        .error  group must be 1 to 1023, the longest shift
        .endc
kRegionColumns = screen_columns+group-1/group
kRegionSize = 0xff00                            ; pixels; rasterising goes some rows beyond a column's end
        .if ne fragments
kRegionSize = kGatheredEnd-kGathered            ; each may be in the list of those to be sent
        .endc

; The greatest power of two of rows that fits, if nothing is said.
        .if ndf band_rows
band_rows = 1
        .rept   9
        .if ge kRegionSize-<2*band_rows*kRegionColumns>
        .if lt band_rows-screen_rows
band_rows = 2*band_rows
        .endc
        .endc
        .endr
        .endc
kRegion = band_rows*kRegionColumns              ; pixels of a band
        .if lt kRegionSize-kRegion
        .error  a band of band_rows rows does not fit into a lane
        .endc
power = 1
log2_band_rows = 0
        .rept   9
        .if lt power-band_rows
power = 2*power
log2_band_rows = log2_band_rows+1
        .endc
        .endr
        .if ne power-band_rows
        .if ne deferred!fragments
        .error  band_rows must be a power of two where shading is deferred or fragments are sent
        .endc
        .endc
bands = screen_rows+band_rows-1/band_rows

; Divisions of x, 0 ... 16383, by a constant: mulu d, x, #inverse, pick.
        .macro  find_inverse inverse, pick, divisor
power = 1
pick = 15
        .rept   16
        .if ge divisor-<2*power>
power = 2*power
pick = pick+1
        .endc
        .endr
inverse = power*0x8000+divisor-1/divisor
        .endm

        find_inverse kPerColumns, kColumnsPick, kRegionColumns
        find_inverse kPerGroup, kGroupPick, group

region_left = other_scratch+50          ; first column of the lane's region
region_right = other_scratch+51         ; last one; may lie beyond the screen
region      = other_scratch+52          ; its number, lane mod group
member      = other_scratch+53          ; lane / group
members     = other_scratch+54          ; lanes / group
row_first   = other_scratch+55          ; of the band being drawn
row_last    = other_scratch+56          ; may lie below the screen
banded_end  = other_scratch+58          ; of `banded`
row_next    = other_scratch+59          ; fragments: the topmost row that the lane has still to draw below the band; kNoRow: none
kNoRow      = 0x4000

; q, rest := x divided by the group, x any word without a sign. t: spoilt.
        .macro  divide_by_group q, rest, x, t
        mulu    q, x, #kPerGroup, kGroupPick
        mul     rest, q, #group
        sub     rest, x, rest
        asr     t, rest, #15            ; beyond 16383 the quotient may be 1 too large
        add     q, q, t
        and     t, t, #group
        add     rest, rest, t
        .endm

; What of the lane's number and `lanes` follows; the first band. Error 3 and halt: lanes are no multiple of the group.
        .macro  find_region
        ld      r1, lane
        ld      r2, lanes
        sub     r2, r2, #1
        divide_by_group r3, r5, r1, r11
        divide_by_group r4, r9, r2, r12
        add     r4, r4, #1
        mul     r6, r5, #kRegionColumns
        add     r7, r6, #kRegionColumns-1
        st      r3, member
        st      r4, members
        st      r5, region
        st      r6, region_left
        st      r7, region_right
        mov     r8, #band_rows-1
        st      r0, row_first
        st      r8, row_last
        tne     r9, #group-1
        bor     lanes_left_over
        .endm

; The pixel at address `at` of the region: its column and row on the screen. t, u: to work with.
        .macro  place column, row, at, t, u
        ld      column, region_left
        ld      row, row_first
        shr     t, at, #log2_band_rows
        and     u, at, #band_rows-1
        add     column, column, t
        add     row, row, u
        .endm

; Sets the procedure pointer to what follows a band.
        .macro  next_band ?none
        setp    finish
        .if gt bands-1
        .if ne fragments
        ld      r26, row_next
        tne     r26, #kNoRow
        bnor    none
        .else
        ld      r26, row_first
        ld      r27, row_last
        add     r26, r26, #band_rows
        add     r27, r27, #band_rows
        st      r26, row_first
        st      r27, row_last
        tlt     r26, #screen_rows
        bf      none
        .endc
        setp    begin_band
none:
        .endc
        .endm
