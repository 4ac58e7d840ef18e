# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A progress bar on the terminal; nothing where there is no terminal."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from contextlib import contextmanager

try:
    from tqdm import tqdm
except ImportError:
    tqdm = None


@contextmanager
def progress_bar(title: str) -> Iterator[Callable[[float], None]]:
    """Gives a function to be called with the part that is done, from 0 to 1."""
    if tqdm is None:
        with _percentages(title) as show:
            yield show
        return
    with tqdm(
        total=100,
        desc=title,
        disable=None,
        leave=False,
        bar_format="{desc}: {percentage:3.0f} %|{bar}| {elapsed}",
    ) as bar:
        yield lambda part: bar.update(int(100 * part) - bar.n)


@contextmanager
def _percentages(title: str) -> Iterator[Callable[[float], None]]:
    if not sys.stderr.isatty():
        yield lambda part: None
        return
    yield lambda part: print(f"\r{title}: {100 * part:3.0f} %", end="", file=sys.stderr, flush=True)
    print("\r" + " " * (len(title) + 8) + "\r", end="", file=sys.stderr, flush=True)
