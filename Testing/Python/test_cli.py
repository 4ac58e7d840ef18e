# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The command line, end to end, in processes of its own."""

import subprocess
import sys

import numpy as np
import pytest
from meshes import floor, joined
from vtkmodules.vtkFiltersSources import vtkLineSource

import lumitree
from lumitree.lightspec import parse_light
from lumitree.surfaces import as_surface

DATA = ["cost.vti", "hierarchy.vtm", "hits.vtp", "irradiance.vtp"]
PICTURES = ["cost.png", "hierarchy.png", "irradiance.png"]


def run(*arguments, code=0):
    done = subprocess.run(
        [sys.executable, "-m", "lumitree", *arguments], capture_output=True, text=True, check=False
    )
    assert done.returncode == code, done.stdout + done.stderr
    assert "Traceback" not in done.stderr
    return done


@pytest.fixture
def mesh(in_tmp):
    lumitree.write(as_surface(joined(floor(0.0), floor(1.0, size=3.0))), "mesh.vtp")
    return "mesh.vtp"


def test_the_main_job(in_tmp, mesh):
    done = run(mesh, "--size", "64x48")
    out = in_tmp / "lumitree-out"
    for name in DATA + PICTURES:
        assert (out / name).stat().st_size > 200, name
    for word in ("4 cells", "4 triangles", "3,072 rays", "Irradiance", "W/m^2", "lumitree-out"):
        assert word in done.stdout, word
    assert done.stderr == ""
    light = lumitree.read(out / "irradiance.vtp")
    assert light.GetCellData().GetScalars().GetName() == "Irradiance [W/m^2]"
    assert lumitree.read(out / "cost.vti").GetPointData().HasArray("NodesEntered")


def test_options(in_tmp, mesh):
    done = run(
        *(
            mesh,
            "--no-pictures",
            "--out",
            "there",
            "--structure",
            "bvh",
            "--precision",
            "watertight",
        ),
        *("--leaf-size", "1", "--threads", "2", "--length-unit", "cm", "--at", "points"),
        *("--tolerance", "0.05"),
        *("--light", "point:0,0,300:1000lm", "--light", "sun:0,0,-1:50lx"),
        *("--eye=-9,-9,9", "--target", "0,0,0", "--bvh-build", "longest_axis_median"),
    )
    assert sorted(p.name for p in (in_tmp / "there").iterdir() if p.is_file()) == DATA
    assert "bvh" in done.stdout and "Illuminance" in done.stdout
    points = lumitree.read("there/irradiance.vtp").GetPointData()
    assert points.HasArray("Illuminance [lx] point")
    assert points.GetScalars().GetName() == "Illuminance [lx]"


def test_a_built_in_scene(in_tmp):
    done = run("scene:cornell_box", "--resolution", "20", "--size", "40x30", "--no-pictures")
    assert "scene:cornell_box: 6,800 cells" in done.stdout
    assert "; 100.0" in done.stdout  # W, of the lamp's 100
    assert "W received in all" in done.stdout


def test_what_the_camera_sees(in_tmp, mesh):
    small = (mesh, "--size", "16x12", "--no-pictures", "--radiance")
    done = run(*small, "--reflectance", "0.25", "--light", "sun:0,0,-1:1000")
    assert "Radiance: 192 pixels" in done.stdout
    seen = lumitree.read(in_tmp / "lumitree-out" / "radiance.vti").GetPointData().GetScalars()
    assert seen.GetName() == "Radiance [W/(m^2 sr)]"
    assert seen.GetRange()[1] == pytest.approx(0.25 * 1000 / np.pi)
    wrong = run(*small, "--reflectance=2", code=2)
    assert "reflectance" in wrong.stderr


def test_structures_side_by_side(in_tmp, mesh):
    done = run(mesh, "--size", "16x12", "--no-pictures", "--compare")
    assert "structures" in done.stdout and "rays/s" in done.stdout
    for structure in ("bvh", "grid", "kd_tree"):
        assert f"\n  {structure}" in done.stdout


def test_help_has_examples():
    done = run("--help")
    for word in (
        "MESH",
        "--light",
        "point:x,y,z:FLUX",
        "--length-unit",
        "scene:",
        "examples:",
        "sun:",
    ):
        assert word in done.stdout, word


@pytest.mark.parametrize(
    ("arguments", "message"),
    [
        (["none.ply"], "there is no file none.ply"),
        (["bad.stl"], "bad.stl cannot be read"),
        (["empty.obj"], "empty.obj is empty or cannot be read"),
        (["line.vtp"], "line.vtp holds no surface"),
        (["a.xyz"], "extension 'xyz' is not known"),
        (["scene:box"], "scene is 'box'; choose one of: cornell_box"),
        (["mesh.vtp", "--light", "lamp"], "light 'lamp' is not written as point:x,y,z:FLUX or spot"),
        (["mesh.vtp", "--light", "sky:blue:100"], "model is 'blue'"),
        (["mesh.vtp", "--light", "sphere:0,0,1:2"], "is not written as sphere:x,y,z:radius"),
        (["mesh.vtp", "--light", "ies:none.ies:0,0,2"], "none.ies: the file cannot be opened"),
        (["mesh.vtp", "--light", "point:0,0:1"], "'0,0' is not three numbers"),
        (
            ["mesh.vtp", "--light", "point:0,0,1:3lx"],
            "'3lx' is not a number with or without a unit",
        ),
        (["mesh.vtp", "--size", "big"], "--size is 'big'"),
        (["mesh.vtp", "--threads", "-3"], "threads must be a whole number"),
        (["mesh.vtp", "--tolerance", "3"], "tolerance must be"),
        (["mesh.vtp", "--resolution", "3"], "--resolution is for built-in scenes"),
        (["mesh.vtp", "--structure", "tree"], "invalid choice: 'tree'"),
        (["mesh.vtp", "--light", "point:0,0,1:3lm", "--light", "sun:0,0,-1:9"], "photometric"),
    ],
)
def test_what_is_wrong_is_told_and_the_code_is_2(mesh, in_tmp, arguments, message):
    (in_tmp / "bad.stl").write_text("no mesh\n")
    (in_tmp / "empty.obj").touch()
    (in_tmp / "a.xyz").touch()
    line = vtkLineSource()
    line.Update()
    lumitree.write(line.GetOutput(), "line.vtp")
    done = run(*arguments, "--no-pictures", code=2)
    assert message in done.stderr
    assert done.stderr.count("\n") == 1 or "usage:" in done.stderr


def test_points_inside_or_outside(in_tmp):
    where = ("--inside", "0,0,0", "--inside", "3,0,0.5")
    done = run("scene:sphere", "--resolution", "4", *where, "--no-pictures", "--precision", "exact")
    assert "0,0,0 is inside; 3,0,0.5 is outside" in done.stdout
    assert "questions open" in done.stdout


def test_no_screen_still_gives_data(in_tmp, mesh, monkeypatch):
    monkeypatch.setenv("DISPLAY", "")
    monkeypatch.setenv("LUMITREE_VIRTUAL_SCREEN", "1")  # as if there were no xvfb-run
    done = run(mesh, "--size", "8x6")
    assert sorted(p.name for p in (in_tmp / "lumitree-out").iterdir() if p.is_file()) == DATA
    assert "no pictures, because there is no screen" in done.stderr


@pytest.mark.parametrize(
    ("text", "field", "value"),
    [
        ("point:0,0,2:1000", "RadiantFlux [W]", 1000.0),
        ("point:-1.5,.5,2e3:1e3W", "RadiantFlux [W]", 1000.0),
        ("point:0,0,2:800lm", "LuminousFlux [lm]", 800.0),
        ("sun:0,0,-1:800", "NormalIrradiance [W/m^2]", 800.0),
        ("sun:0,0,-1:800W/m2", "NormalIrradiance [W/m^2]", 800.0),
        ("sun:0,0,-1:1e5lx", "NormalIlluminance [lx]", 1e5),
    ],
)
def test_lights_as_words(text, field, value):
    assert parse_light(text).GetFieldData().GetArray(field).GetValue(0) == value
