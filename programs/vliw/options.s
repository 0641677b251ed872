; SPDX-License-Identifier: MIT
; The renderer's options, as they are if they have not been set before. Another, `duplication`, is duplicate.s' own.
        .iif ndf line_locked, line_locked = 0   ; 1: a scanline is 910 cycles
        .iif ndf scanlines, scanlines = 525     ; ... and a picture of the video output so many of them
        .iif ndf dense, dense = 1               ; communication, see communicate.s
        .iif ndf stride, stride = 1             ; ... a power of two; 1: no distribution
        .iif ndf textured, textured = 0         ; 1: polygons may have a texture
        .iif ndf early_abort, early_abort = 1   ; rasterising, see rasterise.s
        .iif ndf decoupled, decoupled = 1
        .iif ndf deferred, deferred = 0         ; 1: colours only where pictures are composited, see shade.s
        .iif ndf video, video = 1               ; 0: the picture ends elsewhere than in frame buffers
        .iif ndf migrate, migrate = 1           ; sort-first, see migrate.s: polygons go to where they are on the screen; 2: hidden ones, too
        .if ndf samples                         ; rows between two looks for the next polygon
        .if ne textured&<1-deferred>
samples = 4
        .else
samples = 8
        .endc
        .endc
