; Counts down from 65 536, a thousand times: the shortest program that shows how fast one bare processor runs.
;
; r0    the inner count
; r1    the outer count

        . = 1000
start:  mov     #1000., r1
outer:  clr     r0              ; 65 536 turns: the first step goes from 0 to 177777
inner:  sob     r0, inner
        sob     r1, outer
        halt

        .end    start
