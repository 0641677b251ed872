# SPDX-License-Identifier: MIT
"""What GNU as and objdump make of PDP-11 code: the references the assembler's tests compare with.

usage: make_pdp11_golden.py AS OBJDUMP DIRECTORY

pdp11_encodings.txt    words, tab, instruction; each at 6 times its line's number (from 0)
pdp11_disassembly.txt  words, tab, objdump's text in our spelling
program.aout           what GNU as makes of program.s
"""
import itertools
import os
import re
import struct
import subprocess
import sys
import tempfile

HEADER_BYTES = 16
SINGLE = ("clr com inc dec neg adc sbc tst ror rol asr asl sxt swab jmp "
          "clrb comb incb decb negb adcb sbcb tstb rorb rolb asrb aslb").split()
DOUBLE = "mov cmp bit bic bis add movb cmpb bitb bicb bisb sub".split()
BRANCH = "br bne beq bge blt bgt ble bpl bmi bhi blos bvc bvs bcc bcs bhis blo".split()
PLAIN = "halt wait rti bpt iot reset rtt nop clc clv clz cln ccc sec sev sez sen scc".split()
REGISTERS = "r0 r1 r2 r3 r4 r5 sp pc".split()
MODES = ["{r}", "({r})", "@{r}", "({r})+", "@({r})+", "-({r})", "@-({r})", "{x}({r})", "@{x}({r})", "@({r})"]
PC_MODES = ["#{x}", "@#{x}", ".+{x}", "@.+{x}"]
NUMBERS = ["0", "1", "2", "0100", "-2", "-0100", "077777", "0100000", "0177776"]


def operands():
    """Every mode with every register, with numbers that go round."""
    numbers = itertools.cycle(NUMBERS)
    for mode in MODES:
        for register in REGISTERS:
            yield mode.format(r=register, x=next(numbers))
    for mode in PC_MODES:
        for number in NUMBERS:
            if "." not in mode or number != "0177776":  # past the end of memory: an error of ours
                yield mode.format(x=number.lstrip("-") if "." in mode else number)


def texts():
    yield from PLAIN
    every = list(operands())
    for index, name in enumerate(SINGLE):
        yield from (f"{name} {operand}" for operand in every[index % 3::3])
    step = 0
    for name in DOUBLE:
        for source in every:
            step += 7
            yield f"{name} {source}, {every[step % len(every)]}"
    for name in ("mul", "div", "ash", "ashc"):
        yield from (f"{name} {operand}, {REGISTERS[i % 6]}" for i, operand in enumerate(every))
    for name in ("jsr", "xor"):
        yield from (f"{name} {REGISTERS[i % 8]}, {operand}" for i, operand in enumerate(every))
    for name in BRANCH:
        yield from (f"{name} .{offset}" for offset in ("-0376", "-0100", "-2", "+0", "+2", "+4", "+0100", "+0400"))
    for register in REGISTERS:
        yield f"rts {register}"
        yield from (f"sob {register}, .{offset}" for offset in ("+2", "-0", "-2", "-0100", "-0174"))
    for number in ("0", "1", "7", "012", "077"):
        yield f"mark {number}"
    for number in ("0", "1", "012", "0377"):
        yield from (f"emt {number}", f"trap {number}")


def gnu(text):
    """GNU as writes $ for immediate and begins comments with #."""
    return text.replace("#", "$")


def assemble(assembler, source):
    """The text section, and the whole a.out file."""
    with tempfile.TemporaryDirectory() as folder:
        name, output = os.path.join(folder, "a.s"), os.path.join(folder, "a.o")
        with open(name, "w", encoding="ascii") as file:
            file.write(source)
        subprocess.run([assembler, "-o", output, name], check=True)
        with open(output, "rb") as file:
            whole = file.read()
    return whole[HEADER_BYTES:HEADER_BYTES + struct.unpack_from("<H", whole, 2)[0]], whole


def write_encodings(assembler, path):
    lines = list(texts())
    # Filled up with HALT to 6 bytes; the length of an instruction follows from its first word.
    source = "".join(f"\t.org {6 * i}\n\t{gnu(text)}\n" for i, text in enumerate(lines)) + f"\t.org {6 * len(lines)}\n"
    code, _ = assemble(assembler, source)
    with open(path, "w", encoding="ascii") as file:
        for i, text in enumerate(lines):
            words = struct.unpack_from("<HHH", code, 6 * i)
            file.write(" ".join(f"{word:06o}" for word in words) + f"\t{text}\n")
    return len(lines)


def our_spelling(text):
    """objdump's octal without a leading zero, $ and *, in our notation."""
    text = re.sub(r"\s+", " ", text.strip()).replace("$", "#").replace("*", "@")
    text = re.sub(r"^sys ", "trap ", text)
    condition = re.match(r"^(cl|se)_([0-9a-f])$", text)
    if condition:
        text = "ccodes {:o}".format(int(condition[2], 16) + (16 if condition[1] == "se" else 0))
    mnemonic, _, rest = text.partition(" ")
    rest = re.sub(r"(?<![A-Za-z0-9])([1-7][0-7]+)", r"0\1", rest)
    return f"{mnemonic} {rest}".strip()


def is_plain(word):
    """Neither branch, SOB nor a PC-relative operand: of these objdump prints hexadecimal addresses."""
    if word & 0o177000 == 0o077000 or (word & 0o177400 and word & 0o074000 == 0 and word & 0o177000 != 0o004000
                                       and word & 0o177400 < 0o104000 and word & 0o007000 < 0o004000):
        return False
    return word & 0o67 != 0o67 and word >> 6 & 0o67 != 0o67


def write_disassembly(objdump, path):
    first_words = [word for word in range(0, 0o170000, 11)
                   if is_plain(word) and word & 0o177000 != 0o076000]  # which are the commercial instructions
    followers = itertools.cycle([0o12, 0o177770, 0o1234, 0o2, 0o100000])
    chunks = [(word, next(followers), next(followers)) for word in first_words]
    count = 0
    with open(path, "w", encoding="ascii") as file:
        for chunk in chunks:
            count += write_one(objdump, file, chunk)
    return count


def write_one(objdump, file, words):
    with tempfile.NamedTemporaryFile(suffix=".bin") as binary:
        binary.write(struct.pack("<HHH", *words))
        binary.flush()
        output = subprocess.run([objdump, "-D", "-b", "binary", "-m", "pdp11", binary.name], check=True,
                                capture_output=True, text=True).stdout
    line = next(line for line in output.splitlines() if re.match(r"^\s+0:\t", line))
    text = our_spelling(line.split("\t", 2)[2])
    if re.match(r"^(mfp|mtp|mtps|mfps|csm|tstset|wrtlck|spl|f[a-z]+ |l[23]d|mov[rt]*c|xfc|med|\.word|cfcc|set|ld|st)", text):
        return 0  # not of a PDP-11/40 with EIS
    file.write(" ".join(f"{word:06o}" for word in words) + f"\t{text}\n")
    return 1


def write_program(assembler, directory):
    with open(os.path.join(directory, "program.s"), encoding="ascii") as file:
        source = "".join(gnu(line.split(";")[0].rstrip()) + "\n" for line in file)
    _, whole = assemble(assembler, source)
    with open(os.path.join(directory, "program.aout"), "wb") as file:
        file.write(whole)
    return len(whole)


def main():
    assembler, objdump, directory = sys.argv[1:]
    print(write_encodings(assembler, os.path.join(directory, "pdp11_encodings.txt")), "encodings")
    print(write_disassembly(objdump, os.path.join(directory, "pdp11_disassembly.txt")), "disassembled words")
    print(write_program(assembler, directory), "bytes of a.out")


if __name__ == "__main__":
    main()
