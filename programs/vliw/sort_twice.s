; SPDX-License-Identifier: MIT
; The sort-twice renderer (Eldridge 1995, chapter 6), with `group` regions; where the picture is: composite.s. Set an option by a file that
; assigns it and then includes this one.
        .iif ndf group, group = 64
        .iif ndf deferred, deferred = 1
        .include "regions.s"
        .end    start
