; SPDX-License-Identifier: MIT
; The frame buffer of a processor that draws polygons (programs/README.md). Define frame_buffer_bus as 1 where the image
; window stands in the I/O page.

        .ifndf  frame_buffer_bus
frame_buffer_bus = 0
        .endc

io_fbrow   = 166000             ; selects the row in the windows
io_fbclear = 166002             ; clears all rows to the word written

depth_window = 150000           ; a word a column, 1024 columns
        .ifeq   frame_buffer_bus
image_window = 154000
        .else
image_window = 170000
        .endc
depth_to_image = image_window-depth_window      ; from a pixel's depth word to its image word
