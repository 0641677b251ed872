; SPDX-License-Identifier: MIT
; A renderer whose lanes draw regions of the screen that are composited.
video = 0
        .include "options.s"
        .include "memory.s"
        .include "region.s"
        .include "dispatch.s"
        .include "geometry.s"
        .include "communicate_region.s"
        .include "normalise_region.s"
        .include "rasterise_region.s"
        .include "composite.s"
        .include "finish.s"
