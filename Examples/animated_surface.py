# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""A surface that moves while its cells stay: the tree is refitted frame by frame, and built again
when rays would cost too much."""

import sys

import numpy as np
from vtkmodules.util.numpy_support import vtk_to_numpy

import lumitree

torus = lumitree.scene("torus", resolution=24)
rest = vtk_to_numpy(torus.GetPoints().GetData()).copy()
cells = vtk_to_numpy(torus.GetPolys().GetConnectivityArray()).reshape(-1, 3)
camera = lumitree.camera_rays(eye=(2, -5, 4), target=(0, 0, 0), size=(120, 90))


def frame(time: float) -> np.ndarray:
    """The points at that time: twisted about z, the more so the farther out."""
    angle = time * np.hypot(rest[:, 0], rest[:, 1]) ** 2
    x, y, z = rest.T
    turned = (x * np.cos(angle) - y * np.sin(angle), x * np.sin(angle) + y * np.cos(angle), z)
    return np.stack(turned, axis=1).astype(rest.dtype)


caster = lumitree.Caster(
    (rest, cells), structure="wide_bvh", precision="exact", refit_limit=1.5
)
times = np.linspace(0.0, 1.5, 31)
origins = []
costs = []
for time in times:
    moved = frame(time)
    caster.mesh = (moved, cells)
    hits = caster.cast(camera)
    facts = hits.statistics
    origins.append(facts["Origin"])
    costs.append(facts["SahCost"] / facts["SahCostBuilt"])
    if time in times[[10, 30]]:
        # The hits are those of a tree built for this frame, bit for bit.
        fresh = lumitree.cast((moved, cells), camera, structure="bvh", precision="exact")
        assert np.array_equal(hits.t, fresh.t) and np.array_equal(hits.cell_id, fresh.cell_id)

print(f"{origins.count('built')} frames built, {origins.count('refitted')} refitted")
print(f"a refitted tree costs rays at most {max(costs):.2f} times what it did when it was built")
assert origins[0] == "built" and origins.count("refitted") > len(times) / 2
assert max(costs) <= 1.5

if len(sys.argv) > 1:
    import matplotlib

    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(7.2, 3.2))
    axes.plot(times, costs, color="0.6", zorder=0)
    for origin, colour in (("refitted", "tab:blue"), ("built", "tab:red")):
        chosen = [i for i, name in enumerate(origins) if name == origin]
        axes.scatter(times[chosen], np.array(costs)[chosen], color=colour, label=origin)
    axes.axhline(1.5, color="0.3", linestyle="--", linewidth=1)
    axes.text(times[0], 1.51, "refit_limit", va="bottom")
    axes.set(xlabel="time", ylabel="cost / cost when built", ylim=(0.97, 1.6))
    axes.legend(loc="lower right")
    figure.tight_layout()
    figure.savefig(sys.argv[1], dpi=100)
