# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: GPL-3.0-or-later
"""Ground truth: importing this module adds the structure ``"cgal"``, and ``"cgal_epick"`` and
``"cgal_cartesian"`` (precision ``"fast"`` only), CGAL with less exact numbers, to compare with.

CGAL's AABB tree is under the GNU General Public License, version 3 or later, and so is this module; nothing
else of the package imports it. ::

    import lumitree
    import lumitree.reference

    lumitree.cast(mesh, origins, directions, structure="cgal", precision="exact")

Raises ImportError where Lumitree was built without CGAL.
"""

import ctypes
from pathlib import Path

_NAME = "libLumitreeReferenceCGAL.so"


def _load() -> ctypes.CDLL:
    # <prefix>/lib/python3/dist-packages/lumitree/reference.py; in a build tree the file itself is a link.
    beside = Path(__file__).absolute().parents[3] / _NAME
    try:
        return ctypes.CDLL(str(beside) if beside.exists() else _NAME)
    except OSError as problem:
        raise ImportError(f"this Lumitree was built without CGAL ({problem})") from problem


# The library puts CGAL into the registry of structures when it is loaded.
_library = _load()
