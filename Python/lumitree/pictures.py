# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Pictures of results, rendered off screen into PNG files. They need what `screen_available`
tells."""

from __future__ import annotations

import os

import numpy as np
from vtkmodules.vtkCommonCore import vtkDoubleArray, vtkLookupTable
from vtkmodules.vtkCommonDataModel import vtkImageData, vtkPolyData
from vtkmodules.vtkImagingCore import vtkImageMapToColors
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor
from vtkmodules.vtkRenderingCore import (
    vtkActor,
    vtkColorTransferFunction,
    vtkImageActor,
    vtkPolyDataMapper,
    vtkRenderer,
    vtkRenderWindow,
    vtkWindowToImageFilter,
)

from .arrays import from_vtk
from .camera import View, view_of
from .errors import run

# Imported for what they register: the renderer, and text.
import vtkmodules.vtkRenderingFreeType  # noqa: F401, E402, I001  isort: skip
import vtkmodules.vtkRenderingOpenGL2  # noqa: F401, E402, I001  isort: skip

#: Colours at equal steps, from low to high, after matplotlib's maps of these names (public domain);
#: viridis without its end, as yellow lines are lost on white.
COLOURS = {
    "viridis": "440154 482878 3e4a89 31688e 26828e 1f9e89 35b779 6ece58",
    "inferno": "000004 1b0c41 4a0c6b 781c6d a52c60 cf4446 ed6925 fb9b06 f7d13d fcffa4",
}

SIZE = (1400, 1000)
INK = (0.15, 0.15, 0.18)


def surface_picture(
    path: str | os.PathLike,
    surface: vtkPolyData,
    array_name: str,
    title: str,
    view: View | None = None,
) -> None:
    """A surface coloured by one of its cell or point arrays, from 0 up.

    title : on the scalar bar, with the unit.

    Colours end where 98 % of the finite values lie below, so that a lamp close to a wall does not
    turn the rest black; the largest is told. Faces seen from behind are grey: their values are
    those of the other side.
    """
    on_cells = surface.GetCellData().HasArray(array_name)
    data = surface.GetCellData() if on_cells else surface.GetPointData()
    scale = _Scale("inferno", from_vtk(data, array_name), 0.98)
    actor = vtkActor()
    actor.SetMapper(_mapper(surface, scale, array_name, on_cells))
    actor.GetProperty().LightingOff()  # the colours are the light
    actor.GetProperty().BackfaceCullingOn()
    behind = _plain(surface)
    behind.GetProperty().FrontfaceCullingOn()
    _render(path, [actor, behind], scale.bar(title), view or view_of(surface.GetBounds()))


def boxes_picture(
    path: str | os.PathLike,
    surface: vtkPolyData,
    boxes: vtkPolyData,
    array_name: str,
    title: str,
    view: View | None = None,
) -> None:
    """The lines of `boxes` coloured by a cell array, around the translucent surface."""
    scale = _Scale("viridis", from_vtk(boxes.GetCellData(), array_name))
    lines = vtkActor()
    lines.SetMapper(_mapper(boxes, scale, array_name, on_cells=True))
    lines.GetProperty().LightingOff()
    lines.GetProperty().SetLineWidth(1.5)
    skin = _plain(surface)
    skin.GetProperty().SetOpacity(0.55)
    _render(path, [skin, lines], scale.bar(title), view or view_of(surface.GetBounds()))


def image_picture(
    path: str | os.PathLike, image: vtkImageData, array_name: str, title: str
) -> None:
    """An image coloured by one of its point arrays, pixel by pixel, from 0 up."""
    scale = _Scale("inferno", from_vtk(image.GetPointData(), array_name), 0.998)
    flat = vtkImageData()
    flat.SetDimensions(image.GetDimensions())
    flat.GetPointData().SetScalars(image.GetPointData().GetArray(array_name))
    to_colours = vtkImageMapToColors()
    to_colours.SetInputData(flat)
    to_colours.SetLookupTable(scale.table)
    to_colours.SetOutputFormatToRGB()
    run(to_colours)
    actor = vtkImageActor()
    actor.SetInputData(to_colours.GetOutput())
    actor.InterpolateOff()
    _render(path, [actor], scale.bar(title), None)


class _Scale:
    """Colours from 0 to a round number that `part` of the values lie below; labels at round
    numbers, or at whole ones if the values are."""

    def __init__(self, colours: str, values: np.ndarray, part: float = 1.0) -> None:
        finite = values[np.isfinite(values)]
        self.largest = float(finite.max()) if finite.size else 0.0
        top = float(np.quantile(finite, part)) if finite.size else 0.0
        top = next(value for value in (top, self.largest, 1.0) if value > 0.0)
        step = 10.0 ** np.floor(np.log10(top / 5))
        step *= next(factor for factor in (1, 2, 5, 10) if factor * step * 6 >= top)
        step = max(step, 1.0) if values.dtype.kind == "i" else step
        steps = int(np.ceil(top / step - 1e-9))
        self.labels = [i * step for i in range(steps + 1)]
        self.table = _table(colours, self.labels[-1])

    def bar(self, title: str) -> vtkScalarBarActor:
        labels = vtkDoubleArray()
        for label in self.labels:
            labels.InsertNextValue(label)
        bar = vtkScalarBarActor()
        bar.SetLookupTable(self.table)
        if self.largest > self.labels[-1]:
            title += f"\nat most {self.largest:.4g}"
        bar.SetTitle(title.replace("^2", "\u00b2") + "\n")
        bar.SetUseCustomLabels(True)
        bar.SetCustomLabels(labels)
        bar.SetLabelFormat("%.4g")
        bar.SetMaximumNumberOfColors(256)
        bar.UnconstrainedFontSizeOn()
        bar.SetBarRatio(0.18)
        bar.SetTextPad(4)
        for text, size in ((bar.GetTitleTextProperty(), 24), (bar.GetLabelTextProperty(), 22)):
            text.SetFontFamilyToArial()
            text.SetFontSize(size)
            text.SetColor(*INK)
            text.BoldOff()
            text.ItalicOff()
            text.ShadowOff()
        bar.SetPosition(0.08, 0.1)
        bar.SetWidth(0.9)
        bar.SetHeight(0.8)
        return bar


def _table(colours: str, top: float) -> vtkLookupTable:
    stops = COLOURS[colours].split()
    function = vtkColorTransferFunction()
    function.SetColorSpaceToLab()
    for i, stop in enumerate(stops):
        red, green, blue = (int(stop[k : k + 2], 16) / 255 for k in (0, 2, 4))
        function.AddRGBPoint(i / (len(stops) - 1), red, green, blue)
    table = vtkLookupTable()
    table.SetNumberOfTableValues(256)
    for i in range(256):
        table.SetTableValue(i, *function.GetColor(i / 255), 1.0)
    table.SetRange(0.0, top)
    table.SetNanColor(0.75, 0.75, 0.75, 1.0)
    return table


def _mapper(
    surface: vtkPolyData, scale: _Scale, array_name: str, on_cells: bool
) -> vtkPolyDataMapper:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.SetLookupTable(scale.table)
    mapper.UseLookupTableScalarRangeOn()
    if on_cells:
        mapper.SetScalarModeToUseCellFieldData()
    else:
        mapper.SetScalarModeToUsePointFieldData()
        mapper.InterpolateScalarsBeforeMappingOn()
    mapper.SelectColorArray(array_name)
    return mapper


def _plain(surface: vtkPolyData) -> vtkActor:
    mapper = vtkPolyDataMapper()
    mapper.SetInputData(surface)
    mapper.ScalarVisibilityOff()
    actor = vtkActor()
    actor.SetMapper(mapper)
    actor.GetProperty().SetColor(0.78, 0.81, 0.86)
    actor.GetProperty().SetAmbient(0.45)
    actor.GetProperty().SetDiffuse(0.55)
    return actor


def _render(
    path: str | os.PathLike, actors: list, bar: vtkScalarBarActor, view: View | None
) -> None:
    """Renders actors left of a scalar bar. Without a view they lie in the plane z = 0 and fill the
    picture."""
    renderer = vtkRenderer()
    renderer.SetBackground(1.0, 1.0, 1.0)
    renderer.SetViewport(0.0, 0.0, 0.84, 1.0)
    for actor in actors:
        renderer.AddActor(actor)
    camera = renderer.GetActiveCamera()
    if view:
        camera.SetPosition(view.eye)
        camera.SetFocalPoint(view.target)
        camera.SetViewUp(view.up)
        camera.SetViewAngle(view.angle)
        renderer.ResetCameraClippingRange()
        first, last = camera.GetClippingRange()
        # VTK's choice would cut off what is small and close in a big room.
        camera.SetClippingRange(view.near or min(first, camera.GetDistance() / 100), last)
    else:
        camera.ParallelProjectionOn()
        renderer.ResetCamera()
        low_x, high_x, low_y, high_y = actors[0].GetBounds()[:4]
        aspect = 0.84 * SIZE[0] / SIZE[1]
        camera.SetParallelScale(0.5 * max(high_y - low_y, (high_x - low_x) / aspect) * 1.02)
    legend = vtkRenderer()
    legend.SetBackground(1.0, 1.0, 1.0)
    legend.SetViewport(0.84, 0.0, 1.0, 1.0)
    legend.AddActor2D(bar)

    window = vtkRenderWindow()
    window.SetOffScreenRendering(1)
    window.SetMultiSamples(8)
    window.SetSize(*SIZE)
    window.AddRenderer(renderer)
    window.AddRenderer(legend)
    window.Render()
    grab = vtkWindowToImageFilter()
    grab.SetInput(window)
    grab.ReadFrontBufferOff()
    writer = vtkPNGWriter()
    writer.SetFileName(os.fspath(path))
    writer.SetInputConnection(grab.GetOutputPort())
    writer.Write()
    window.Finalize()
