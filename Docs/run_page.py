# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the Python on a page, block after block, as one program: what a page shows works.

python3 Docs/run_page.py PAGE.md
"""

from __future__ import annotations

import sys
from pathlib import Path


def blocks_of(text: str) -> list[tuple[int, str]]:
    """The fenced blocks marked ``python``: the line each starts at, and its code."""
    blocks, code = [], None
    for number, line in enumerate(text.splitlines(), start=1):
        if code is None and line.strip() == "```python":
            code, start = [], number
        elif code is not None and line.strip() == "```":
            blocks.append((start, "\n".join(code)))
            code = None
        elif code is not None:
            code.append(line)
    return blocks


def run_page(page: Path) -> dict[str, object]:
    """Runs the page's blocks, and returns the variables they leave. Errors name the page's lines."""
    names: dict[str, object] = {"__name__": "__main__"}
    blocks = blocks_of(page.read_text(encoding="utf-8"))
    if not blocks:
        raise ValueError(f"{page} shows no Python")
    for start, code in blocks:
        exec(compile("\n" * start + code, str(page), "exec"), names)
    return names


if __name__ == "__main__":
    run_page(Path(sys.argv[1]))
