# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Reading surfaces and writing results, with VTK's readers and writers."""

from __future__ import annotations

import os
from importlib import import_module
from pathlib import Path

from vtkmodules.vtkCommonDataModel import (
    vtkCompositeDataSet,
    vtkDataObject,
    vtkDataSet,
    vtkMultiBlockDataSet,
)

from .errors import LumitreeError, reported, run

#: Extension: (module, class) of its reader.
READERS = {
    "ply": ("vtkIOPLY", "vtkPLYReader"),
    "stl": ("vtkIOGeometry", "vtkSTLReader"),
    "obj": ("vtkIOGeometry", "vtkOBJReader"),
    "glb": ("vtkIOGeometry", "vtkGLTFReader"),
    "gltf": ("vtkIOGeometry", "vtkGLTFReader"),
    "vtk": ("vtkIOLegacy", "vtkGenericDataObjectReader"),
    "vtp": ("vtkIOXML", "vtkXMLPolyDataReader"),
    "vtu": ("vtkIOXML", "vtkXMLUnstructuredGridReader"),
    "vts": ("vtkIOXML", "vtkXMLStructuredGridReader"),
    "vtr": ("vtkIOXML", "vtkXMLRectilinearGridReader"),
    "vti": ("vtkIOXML", "vtkXMLImageDataReader"),
    "vtm": ("vtkIOXML", "vtkXMLMultiBlockDataReader"),
    "vtpd": ("vtkIOXML", "vtkXMLPartitionedDataSetReader"),
    "vtpc": ("vtkIOXML", "vtkXMLPartitionedDataSetCollectionReader"),
    "pvtp": ("vtkIOXML", "vtkXMLPPolyDataReader"),
    "pvtu": ("vtkIOXML", "vtkXMLPUnstructuredGridReader"),
}


def read(path: str | os.PathLike) -> vtkDataObject:
    """The data set (or composite) in a file that VTK reads; the extension says how.

    Raises FileNotFoundError, ValueError for an extension that is not known (the message lists
    them), and LumitreeError for a file that cannot be read or holds no cells.
    """
    file = Path(path)
    if not file.is_file():
        raise FileNotFoundError(
            f"{file} is not a file" if file.exists() else f"there is no file {file}"
        )
    extension = file.suffix.lower().lstrip(".")
    if extension not in READERS:
        raise ValueError(
            f"{file}: extension {extension!r} is not known; VTK reads: {', '.join(READERS)}"
        )
    if not os.access(file, os.R_OK):
        raise LumitreeError(f"{file} may not be read")
    module, name = READERS[extension]
    reader = getattr(import_module(f"vtkmodules.{module}"), name)()
    reader.SetFileName(str(file))

    try:
        run(reader)
    except LumitreeError as error:
        raise LumitreeError(f"{file} cannot be read: {error}") from None
    result = reader.GetOutputDataObject(0)
    if not isinstance(result, (vtkDataSet, vtkCompositeDataSet)):
        raise LumitreeError(f"{file} cannot be read: it holds no data set")
    if result.GetNumberOfCells() == 0:
        raise LumitreeError(f"{file} is empty or cannot be read: no cells were found in it")
    return result


def write(data: vtkDataObject, path: str | os.PathLike) -> None:
    """Writes a data set, a table or a multiblock in VTK's XML format; to ``.ies`` and ``.ldt`` a
    light, or a photometric solid of `radiant_intensity`, as IES LM-63 or EULUMDAT. Raises
    LumitreeError when that fails."""
    from vtkmodules.vtkIOXML import vtkXMLDataObjectWriter, vtkXMLMultiBlockDataWriter

    if Path(path).suffix.lower() in (".ies", ".ldt"):
        from .vtk import vtkLumiPhotometricWriter

        photometric = vtkLumiPhotometricWriter()
        photometric.SetFileName(str(path))
        photometric.SetInputDataObject(data)
        with reported(photometric, photometric.GetExecutive()):
            photometric.Write()
        return
    if isinstance(data, vtkMultiBlockDataSet):
        writer = vtkXMLMultiBlockDataWriter()
    else:
        writer = vtkXMLDataObjectWriter.NewWriter(data.GetDataObjectType())
    if writer is None:
        raise LumitreeError(
            f"{path} cannot be written: there is no writer for {data.GetClassName()}"
        )
    writer.SetFileName(str(path))
    writer.SetInputDataObject(data)
    # Not appended: VTK's reader with Debian 12's expat (2.5.0-1+deb12u2) takes some of its own files
    # with appended data for ill-formed.
    writer.SetDataModeToBinary()
    try:
        with reported(writer, writer.GetExecutive()):
            writer.Write()
    except LumitreeError as error:
        raise LumitreeError(f"{path} cannot be written: {error}") from None
