# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A structure that took long to build is kept in a file, and is there at once the next time."""

import tempfile
from pathlib import Path

import numpy as np

import lumitree

city = lumitree.scene("city", resolution=3)
camera = lumitree.camera_rays(eye=(-150, -200, 120), target=(60, 60, 0), size=(160, 120))

with tempfile.TemporaryDirectory() as directory:
    path = Path(directory) / "city.lumitree"
    facts = lumitree.save_structure(city, path, "bsp_tree")
    print(f"built in {1e3 * facts['BuildSeconds']:.0f} ms, {path.stat().st_size:,} bytes saved")

    loaded = lumitree.hierarchy(city, "bsp_tree", structure_file=path)
    facts = loaded.statistics
    print(f"{facts['Origin']} in {1e3 * facts['BuildSeconds']:.0f} ms, {facts['Nodes']} nodes")

    # The rays find the tree that `loaded` holds. They hit what brute force says they hit.
    hits = lumitree.cast(city, camera, structure="bsp_tree", precision="exact")
    wanted = lumitree.cast(city, camera, structure="brute_force", precision="exact")
    assert hits.statistics["Origin"] == "loaded"
    assert np.array_equal(hits.t, wanted.t) and np.array_equal(hits.cell_id, wanted.cell_id)

    # A file is of one surface.
    try:
        other = lumitree.scene("city", resolution=4)
        lumitree.hierarchy(other, structure_file=path, structure_file_use="load")
    except lumitree.LumitreeError as error:
        print("refused:", error)
    else:
        raise AssertionError("a structure of another surface was taken")
