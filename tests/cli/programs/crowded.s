; Bundles that the VLIW does not have.
        add     r1, r2, r3 | sub r4, r5, r6
        add     r1, r2, r3 | mul r4, r5, r6 | st r7, 0
        halt
