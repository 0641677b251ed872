# SPDX-License-Identifier: MIT
"""Tables as Markdown and as one self-contained HTML page. A page is a list of paragraphs (str), pictures and tables."""

import base64
import os
from dataclasses import dataclass, field
from html import escape
from pathlib import Path

STYLE = """
body { font: 15px/1.5 system-ui, sans-serif; margin: 2em auto; max-width: 1300px; padding: 0 1em; color: #222; background: #fff; }
table { border-collapse: collapse; margin: 1em 0; font-size: 13px; }
th, td { border: 1px solid #ccc; padding: .3em .6em; text-align: left; vertical-align: top; }
th { background: #eee; position: sticky; top: 0; }
td.good { background: #dff2df; } td.bad { background: #fbe3d6; } td.odd { background: #fdf3c7; } td.none { background: #eee; }
img { max-width: 100%; } code { background: #f3f3f3; padding: 0 .2em; }
"""


@dataclass
class Heading:
    text: str
    level: int = 2


@dataclass
class Table:
    head: list
    rows: list
    classes: dict = field(default_factory=dict)  # text of a cell: "good", "bad", "odd", "none"


@dataclass
class Picture:
    path: Path
    text: str


def markdown(title, parts, folder="."):
    """`folder` is where the page will stand: pictures are named from there."""
    lines = [f"# {title}", ""]
    for part in parts:
        lines += [*_markdown_part(part, folder), ""]
    return "\n".join(lines)


def _markdown_part(part, folder):
    if isinstance(part, Heading):
        return ["#" * part.level + " " + part.text]
    if isinstance(part, Table):
        return [_row(part.head), "|" + "---|" * len(part.head), *map(_row, part.rows)]
    if isinstance(part, Picture):
        return [f"![{part.text}]({os.path.relpath(part.path, folder)})"]
    return [part]


def _row(cells):
    return "| " + " | ".join(str(cell).replace("|", "\\|").replace("\n", " ") for cell in cells) + " |"


def html(title, parts):
    body = "\n".join(map(_html_part, parts))
    return (f"<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><title>{escape(title)}</title>"
            f"<style>{STYLE}</style></head>\n<body>\n<h1>{escape(title)}</h1>\n{body}\n</body></html>\n")


def _html_part(part):
    if isinstance(part, Heading):
        return f"<h{part.level}>{escape(part.text)}</h{part.level}>"
    if isinstance(part, Table):
        head = "".join(f"<th>{escape(str(cell))}</th>" for cell in part.head)
        return f"<table><thead><tr>{head}</tr></thead><tbody>\n" + "\n".join(_html_row(row, part.classes) for row in part.rows) + "</tbody></table>"
    if isinstance(part, Picture):
        data = base64.b64encode(Path(part.path).read_bytes()).decode("ascii")
        return f"<p><img alt=\"{escape(part.text)}\" src=\"data:image/png;base64,{data}\"></p>"
    return f"<p>{_code(part)}</p>"


def _html_row(row, classes):
    cells = (f"<td class=\"{classes[cell]}\">" if cell in classes else "<td>" for cell in map(str, row))
    return "<tr>" + "".join(f"{cell}{_code(str(text))}</td>" for cell, text in zip(cells, row)) + "</tr>"


def _code(text):
    """Backquoted words as code; everything else is text."""
    pieces = text.split("`")
    return "".join(f"<code>{escape(piece)}</code>" if i % 2 else escape(piece) for i, piece in enumerate(pieces))
