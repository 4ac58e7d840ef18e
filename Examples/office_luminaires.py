# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Luminaires of photometric files over a work plane: illuminance, its mean and its evenness."""

from pathlib import Path

import numpy as np
from vtkmodules.vtkFiltersSources import vtkPlaneSource

import lumitree

LUMINAIRES = Path(__file__).resolve().parents[1] / "Data" / "Luminaires"

# A room of 6 m x 4.8 m; the luminaires hang 1.95 m over the work plane.
plane = vtkPlaneSource()
plane.SetOrigin(0, 0, 0.75)
plane.SetPoint1(6, 0, 0.75)
plane.SetPoint2(0, 4.8, 0.75)
plane.SetResolution(60, 48)
plane.Update()

for file in ("panel.ldt", "downlight.ies"):
    lamps = [
        lumitree.photometric_light(LUMINAIRES / file, (x, y, 2.7), name=f"{x} {y}")
        for x in (1.0, 3.0, 5.0)
        for y in (1.2, 3.6)
    ]
    fields = lamps[0].GetFieldData()
    flux = fields.GetArray("LuminousFlux [lm]").GetValue(0)
    stated = fields.GetArray("StatedLuminousFlux [lm]").GetValue(0)
    light = lumitree.irradiance(plane.GetOutput(), lamps)
    mean = light.values.mean()
    print(
        f"{fields.GetAbstractArray('LuminaireName').GetValue(0)}: {flux:.0f} lm between the angles, "
        f"{stated:.0f} lm stated; mean {mean:.0f} lx, least / mean {light.values.min() / mean:.2f}"
    )
    assert light.name == "Illuminance [lx]"
    # The plane catches most of the light that goes down, and no more than there is.
    assert 0.5 * 6 * flux < light.values.sum() * 0.01 < 6 * flux
    # Below one luminaire alone: I / h^2.
    below = lumitree.irradiance(
        (np.array([(3, 1.2, 0.75), (3.001, 1.2, 0.75), (3, 1.201, 0.75)]), np.array([(0, 1, 2)])),
        lamps[2],
        at="points",
    )
    axis = fields.GetArray("PhotometricLuminousIntensity [cd]").GetValue(0)
    assert abs(below.values[0] - axis / 1.95**2) < 1e-6 * below.values[0]
