# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Makes the pictures of walkthrough.md from the variables that its program leaves. Needs matplotlib
and a screen (xvfb-run).

xvfb-run -a python3 Docs/make_walkthrough_pictures.py
"""

from __future__ import annotations

from pathlib import Path

import matplotlib
import numpy as np
from run_page import run_page
from vtkmodules.util.numpy_support import vtk_to_numpy

from lumitree.camera import View
from lumitree.pictures import surface_picture
from lumitree.stages import stage_of

matplotlib.use("Agg")
from matplotlib import pyplot  # noqa: E402  after the choice of back end
from matplotlib.patches import Rectangle  # noqa: E402

HERE = Path(__file__).resolve().parent
DPI = 100
COLOURS = {"longest_axis_median": "#b2182b", "binned_sah": "#2166ac"}
NAMES = {"longest_axis_median": "longest axis, median", "binned_sah": "surface-area heuristic"}


def path_of(name: str) -> Path:
    return HERE / "images" / f"walkthrough-{name}.png"


def save(figure: pyplot.Figure, name: str) -> None:
    figure.savefig(path_of(name), dpi=DPI, bbox_inches="tight")
    pyplot.close(figure)


def slabs() -> None:
    """A ray through a box in the plane, and when it is between each pair of sides."""
    origin, direction = np.array((-2.6, -1.4)), np.array((1.0, 0.62))
    t = (np.array([(-1, -1), (1, 1)]) - origin) / direction
    figure, (left, right) = pyplot.subplots(
        1, 2, figsize=(9, 4), gridspec_kw={"width_ratios": (1.3, 1)}
    )
    left.axvspan(-1, 1, color="#2166ac", alpha=0.12, lw=0)
    left.axhspan(-1, 1, color="#b2182b", alpha=0.12, lw=0)
    left.add_patch(Rectangle((-1, -1), 2, 2, fill=False, lw=2))
    left.annotate("", origin + 4.9 * direction, origin, arrowprops={"arrowstyle": "->", "lw": 1.5})
    left.plot(*origin, "ko")
    left.text(origin[0], origin[1] - 0.3, "o", ha="center")
    for axis, colour in enumerate(("#2166ac", "#b2182b")):
        for value in t[:, axis]:
            left.plot(*(origin + value * direction), "o", color=colour)
    left.set(xlim=(-3, 2.6), ylim=(-2, 2), aspect="equal", xlabel="x", ylabel="y")
    for axis, (colour, name) in enumerate((("#2166ac", "x"), ("#b2182b", "y"))):
        right.plot(t[:, axis], (2 - axis, 2 - axis), "o-", color=colour, lw=4)
        right.text(t[0, axis], 2.2 - axis, f"between the planes of {name}", color=colour)
    enter, leave = t[0].max(), t[1].min()
    right.plot((enter, leave), (0, 0), "ko-", lw=4)
    right.text(enter, 0.2, "inside the box")
    for value, label in ((enter, "$t_{enter}$"), (leave, "$t_{exit}$")):
        right.axvline(value, color="0.6", lw=1, zorder=0)
        right.text(value, -0.75, label, ha="center")
    right.set(xlim=(0, 5), ylim=(-1, 3), xlabel="t", yticks=())
    save(figure, "slabs")


def levels(names: dict[str, object]) -> None:
    """The boxes of four levels, seen from the side that the teapot's profile shows."""
    teapot = names["teapot"]
    points = vtk_to_numpy(teapot.GetPoints().GetData())
    figure, panels = pyplot.subplots(2, 2, figsize=(9, 5.2), sharex=True, sharey=True)
    for panel, depth in zip(panels.flat, (1, 3, 5, 7)):
        panel.plot(points[:, 0], points[:, 2], ",", color="0.55")
        lower, upper = names["boxes_of"](names["tree"].levels.GetBlock(depth))
        for low, high in zip(lower, upper):
            panel.add_patch(
                Rectangle(low[[0, 2]], *(high - low)[[0, 2]], fill=False, color="#2166ac", lw=0.7)
            )
        panel.set(title=f"level {depth}: {len(lower)} boxes", aspect="equal")
        panel.set_axis_off()
    save(figure, "levels")


def cost(names: dict[str, object]) -> None:
    pictures = names["pictures"]
    top = np.quantile(list(pictures.values()), 0.998)
    figure, panels = pyplot.subplots(1, 2, figsize=(9.6, 3.4), layout="constrained")
    for panel, (build, picture) in zip(panels, pictures.items()):
        image = panel.imshow(picture, origin="lower", cmap="inferno", vmin=0, vmax=top)
        panel.set_title(f"{NAMES[build]}: {picture.mean():.2f} nodes a ray", fontsize=10)
        panel.set_axis_off()
    figure.colorbar(image, ax=panels, label="nodes entered", shrink=0.85)
    save(figure, "cost")


def leaf_size(names: dict[str, object]) -> None:
    figure, panels = pyplot.subplots(1, 2, figsize=(9, 3.4), layout="constrained")
    sizes = names["sizes"]
    for build in names["builds"]:
        values = np.array([names["bargain"][build, size] for size in sizes])
        for panel, column in zip(panels, values.T):
            panel.plot(sizes, column, "o-", color=COLOURS[build], label=NAMES[build])
    for panel, what in zip(panels, ("nodes entered", "triangles tested")):
        panel.set_xscale("log", base=2)
        panel.set_xticks(sizes, labels=[str(size) for size in sizes])
        panel.set(xlabel="leaf size", ylabel=f"{what} a ray", ylim=(0, None))
        panel.legend(frameon=False)
    save(figure, "leaf-size")


def point_light(names: dict[str, object]) -> None:
    """Irradiance from above, and along the line y = 0 beside the formula."""
    x, y, light = names["x"], names["y"], names["ground_light"].values
    figure, (left, right) = pyplot.subplots(1, 2, figsize=(9, 3.6), layout="constrained")
    side = int(np.sqrt(len(x)))
    image = left.imshow(
        light.reshape(side, side), extent=(-0.5, 0.5, -0.5, 0.5), origin="lower", cmap="inferno"
    )
    left.set(xlabel="x [m]", ylabel="y [m]")
    figure.colorbar(image, ax=left, label="E [W/m²]")
    row = np.abs(y) < 1e-9
    right.plot(x[row], names["expected"][row], "-", color="0.6", lw=4, label="I cos θ / r²")
    right.plot(x[row][::4], light[row][::4], "o", ms=4, color="#b2182b", label="Lumitree")
    right.set(xlabel="x [m], y = 0", ylabel="E [W/m²]", ylim=(0, None))
    right.legend(frameon=False)
    save(figure, "point-light")


def room(names: dict[str, object]) -> None:
    light = names["light"]
    view: View = stage_of("cornell_box").view
    path = path_of("room")
    surface_picture(path, light.dataset, light.name, f"Irradiance\n[{light.unit}]", view)
    picture = pyplot.imread(path)
    height, width, channels = picture.shape
    halved = picture.reshape(height // 2, 2, width // 2, 2, channels).mean(axis=(1, 3))
    pyplot.imsave(path, halved)


if __name__ == "__main__":
    found = run_page(HERE / "walkthrough.md")
    (HERE / "images").mkdir(exist_ok=True)
    slabs()
    levels(found)
    cost(found)
    leaf_size(found)
    point_light(found)
    room(found)
