# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""What a mesh may be."""

import pytest
from meshes import floor
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkMultiBlockDataSet
from vtkmodules.vtkIOGeometry import vtkSTLWriter
from vtkmodules.vtkIOLegacy import vtkDataSetWriter
from vtkmodules.vtkIOPLY import vtkPLYWriter

import lumitree
from lumitree.surfaces import as_surface

DOWN = (0.0, 0.0, -1.0)
ABOVE = (1.0, 2.0, 5.0)


def test_a_composite_is_one_scene():
    inner, outer = vtkMultiBlockDataSet(), vtkMultiBlockDataSet()
    inner.SetBlock(0, as_surface(floor(1.0)))
    outer.SetBlock(0, as_surface(floor(0.0)))
    outer.SetBlock(2, inner)
    hits = lumitree.cast(outer, ABOVE, DOWN, query="all")
    assert hits.t.tolist() == [4.0, 5.0]
    assert hits.cell_id.tolist() == [1, 1]
    assert hits.composite_index.tolist() == [4, 1]


def test_of_a_volume_it_is_the_outer_surface():
    block = vtkImageData()
    block.SetDimensions(3, 3, 3)
    hits = lumitree.cast(block, (0.3, 1.6, 9.0), DOWN, query="all")
    assert hits.t.tolist() == [7.0, 9.0]
    assert hits.cell_id.tolist() == [6, 2]  # the voxels


@pytest.mark.parametrize(
    ("name", "writer"),
    [
        ("a.ply", vtkPLYWriter),
        ("a.stl", vtkSTLWriter),
        ("a.vtk", vtkDataSetWriter),
        ("a.vtp", None),
    ],
)
def test_a_file(in_tmp, name, writer):
    if writer:
        out = writer()
        out.SetInputData(as_surface(floor()))
        out.SetFileName(name)
        out.Write()
    else:
        lumitree.write(as_surface(floor()), name)
    for path in (name, in_tmp / name):
        assert lumitree.cast(path, ABOVE, DOWN).t == pytest.approx([5.0])


def test_an_obj_file(in_tmp):
    (in_tmp / "a.obj").write_text("v 0 0 0\nv 2 0 0\nv 0 2 0\nf 1 2 3\n")
    assert lumitree.cast("a.obj", (0.5, 0.5, 1), DOWN).t.tolist() == [1.0]


def test_files_that_cannot_be_read(in_tmp, capfd):
    with pytest.raises(FileNotFoundError, match="there is no file none.ply"):
        lumitree.read("none.ply")
    (in_tmp / "a.xyz").touch()
    with pytest.raises(ValueError, match="extension 'xyz' is not known; VTK reads: ply, stl"):
        lumitree.read("a.xyz")
    for name in ("a.obj", "a.stl", "a.ply", "a.vtk", "a.vtp"):
        (in_tmp / name).write_text("no mesh\n")
        with pytest.raises(lumitree.LumitreeError, match=f"{name} (is empty or )?cannot be read"):
            lumitree.read(name)
    with pytest.raises(lumitree.LumitreeError, match="cannot be written"):
        lumitree.write(as_surface(floor()), "no/such/directory.vtp")


def test_scenes():
    for name in (scene.name.lower() for scene in lumitree.Scene):
        mesh = lumitree.scene(name, resolution=3)
        assert mesh.GetNumberOfCells() > 0 and mesh.GetCellData().HasArray("Reflectance")
    with pytest.raises(ValueError, match="name is 'box'; choose one of: cornell_box, teapot"):
        lumitree.scene("box")
    with pytest.raises(ValueError, match="resolution must be a whole number from 1 to 1000"):
        lumitree.scene("teapot", resolution=0)
