# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What VTK reports becomes Python exceptions and warnings."""

from __future__ import annotations

import re
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


def run(algorithm: vtkAlgorithm, progress: Callable[[float], None] | None = None) -> None:
    """Updates an algorithm.

    progress : called with the part that is done, from 0 to 1, on this thread. What it raises
        (KeyboardInterrupt, for instance) stops the algorithm and is raised here.

    Raises LumitreeError with the message of the algorithm's error, if it has one.
    """
    raised: list[BaseException] = []

    def on_progress(caller: vtkAlgorithm, _event: str) -> None:
        try:
            progress(caller.GetProgress())
        except BaseException as error:  # VTK would print it and go on
            raised.append(error)
            caller.SetAbortExecute(1)

    tag = algorithm.AddObserver("ProgressEvent", on_progress) if progress else None
    try:
        with reported(algorithm, algorithm.GetExecutive()):
            algorithm.Update()
    finally:
        if tag is not None:
            algorithm.RemoveObserver(tag)
            algorithm.SetAbortExecute(0)
        if raised:
            raise raised[0]
