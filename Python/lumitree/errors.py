# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK reports becomes Python exceptions and warnings."""

from __future__ import annotations

import re
import signal
import threading
import warnings
from collections.abc import Callable, Iterator
from contextlib import contextmanager

from vtkmodules.util.misc import calldata_type
from vtkmodules.vtkCommonCore import VTK_STRING, vtkObject
from vtkmodules.vtkCommonExecutionModel import vtkAlgorithm


class LumitreeError(RuntimeError):
    """A filter or a reader refused its input; the message is the filter's."""


class LumitreeWarning(UserWarning):
    """A filter computed what it could and says what it left out."""


#: VTK's own head of a message: where it comes from, and the address of the object.
_HEAD = re.compile(r"^(?:ERROR|Warning): In .*?, line \d+\n(?:\w+ \([^)]*\): )?", re.DOTALL)


#: What the executive adds to every failure, after the algorithm's own reason.
_ECHO = " returned failure for request"


def _plain(message: str | None) -> str:
    return _HEAD.sub("", message or "no reason given").strip()


@contextmanager
def reported(*objects: vtkObject) -> Iterator[None]:
    """Raises LumitreeError on leaving, if one of the objects reported an error meanwhile.

    Their warnings become LumitreeWarning. Nothing is printed by VTK.
    """
    errors: list[str] = []
    cautions: list[str] = []

    @calldata_type(VTK_STRING)
    def on_error(_caller: vtkObject, _event: str, message: str | None) -> None:
        errors.append(_plain(message))

    @calldata_type(VTK_STRING)
    def on_warning(_caller: vtkObject, _event: str, message: str | None) -> None:
        cautions.append(_plain(message))

    tags = []
    for item in objects:
        tags.append((item, item.AddObserver("ErrorEvent", on_error)))
        tags.append((item, item.AddObserver("WarningEvent", on_warning)))
    try:
        yield
    finally:
        for item, tag in tags:
            item.RemoveObserver(tag)
    if errors:
        reasons = [error for error in errors if _ECHO not in error]
        raise LumitreeError("; ".join(dict.fromkeys(reasons)) or "no reason given")
    for caution in dict.fromkeys(cautions):
        warnings.warn(caution, LumitreeWarning, stacklevel=4)


@contextmanager
def _interrupt(stop: Callable[[BaseException], None]) -> Iterator[None]:
    """Calls `stop` on Ctrl-C, instead of raising it wherever Python is: VTK ends the process when a
    KeyboardInterrupt comes out of an observer."""
    ours = threading.current_thread() is threading.main_thread()
    if not ours or signal.getsignal(signal.SIGINT) is not signal.default_int_handler:
        yield
        return
    signal.signal(signal.SIGINT, lambda _number, _frame: stop(KeyboardInterrupt()))
    try:
        yield
    finally:
        signal.signal(signal.SIGINT, signal.default_int_handler)


def run(algorithm: vtkAlgorithm, progress: Callable[[float], None] | None = None) -> None:
    """Updates an algorithm.

    progress : called with the part that is done, from 0 to 1, on this thread. What it raises stops
        the algorithm and is raised here; so is Ctrl-C, with or without it.

    Raises LumitreeError with the message of the algorithm's error, if it has one.
    """
    raised: list[BaseException] = []

    def stop(error: BaseException) -> None:
        raised.append(error)
        algorithm.SetAbortExecute(1)

    def on_progress(caller: vtkAlgorithm, _event: str) -> None:
        try:
            if progress:
                progress(caller.GetProgress())
        except BaseException as error:  # VTK would print it and go on
            stop(error)

    tag = algorithm.AddObserver("ProgressEvent", on_progress)
    try:
        with _interrupt(stop), reported(algorithm, algorithm.GetExecutive()):
            algorithm.Update()
    finally:
        algorithm.RemoveObserver(tag)
        algorithm.SetAbortExecute(0)
        if raised:
            raise raised[0]
