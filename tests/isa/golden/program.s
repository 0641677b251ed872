; A word-frequency counter in the subset GNU as and this assembler share (leading zeros for octal, no local labels),
; written as real programs are: stack, tables, strings, byte loops, calls through tables.

limit = 0100
newline = 012
entry_size = 6

start:  mov     #stack, sp
        clr     r5
        mov     #table, r4
        mov     #limit*3, r0
clear:  clr     (r4)+
        sob     r0, clear
        mov     #text, r1
words:  tstb    (r1)
        beq     done
        cmpb    (r1), #040
        bne     word
        inc     r1
        br      words
word:   mov     r1, -(sp)
        jsr     pc, hash
        mov     (sp)+, r2
        mov     r0, -(sp)
        jsr     r5, enter
        .word   table
        .word   limit
        tst     (sp)+
        br      words
done:   mov     count, r0
        jsr     pc, @report
        halt

; r1: the word's first letter; afterwards behind the word. r0: the hash.
hash:   clr     r0
        clr     r3
hloop:  movb    (r1)+, r3
        beq     hend
        cmp     r3, #040
        beq     hout
        bic     #0177400, r3
        ash     #3, r0
        xor     r3, r0
        br      hloop
hend:   dec     r1
hout:   bic     #0100000, r0
        rts     pc

; r5 points to the table's address and its number of entries.
enter:  mov     (r5)+, r3
        mov     (r5)+, -(sp)
        mov     4(sp), r0
        mov     r1, -(sp)
        mov     r0, r1
        clr     r0
        div     2(sp), r0
        mul     #entry_size, r1
        add     r1, r3
        mov     (sp)+, r1
        tst     (sp)+
        tst     4(r3)
        bne     again
        inc     count
        mov     r2, (r3)
        mov     2(sp), 2(r3)
again:  inc     4(r3)
        rts     r5

print:  mov     #message, r1
        swab    r0
        asl     r0
        rol     r0
        bisb    @pointer, -1(r1)
        movb    letters+2, @#message+3
        cmp     -(r1), @(r2)+
        bit     @-(r3), @2(r4)
        rts     pc

report: .word   print
pointer: .word  letters
count:  .word   0
vector: .word   start, words, done-start, -1, limit-1
        .byte   1, 2, 0377, -1, 'a, newline
        .even
letters: .ascii "abc"
        .byte   0
message: .asciz "words: "
text:   .asciz  "the cat and the dog and the bird"
        .even
table:  .word   0, 0, 0
        .word   0177777, 012345, 07
stack:  .word   0
