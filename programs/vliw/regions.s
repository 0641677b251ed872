; SPDX-License-Identifier: MIT
; A renderer whose lanes draw regions of the screen that are composited, or sent as fragments (region.s).
        .iif ndf fragments, fragments = 0
video = fragments
        .include "options.s"
        .include "memory.s"
        .include "region.s"
        .include "dispatch.s"
        .include "geometry.s"
        .include "communicate_region.s"
        .include "normalise_region.s"
        .include "rasterise_region.s"
        .if ne fragments
        .include "fragments.s"
        .else
        .include "composite.s"
        .endc
        .include "finish.s"
