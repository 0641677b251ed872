; SPDX-License-Identifier: MIT
; The loop of rasterise.s and rasterise_region.s: on every scanline kRounds times `samples` rows, until no lane has anything left; if the machine is not
; line-locked, all rows at once. The including file says by macros which registers last from scanline to scanline (raster_words, with `ld` or `st`), how
; lanes that are done go on (advance), whether a lane has something left (anything_left), and which procedure is next (rasterised). Counter: c5.

        .if ne samples&1
        .error  samples must be even
        .endc

rasterise_some:
        wake
        raster_words ld
        .if ne line_locked
        setc    c5, kRounds
        .endc
rasterise_round:
        .if eq decoupled
        tltu    pixel, pixels
        bor     rasterise_rows
        .endc
        advance
rasterise_rows:
        .rept   samples/2
        sample  inside0, inside1
        sample  inside1, inside0
        .endr
        .if ne line_locked
        dec     c5, rasterise_round
        .endc
        anything_left
        .if ne line_locked
        bor     rasterise_save
        .else
        bor     rasterise_round
        .endc
        rasterised
rasterise_save:
        raster_words st
        line
