# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The proxies say what the classes say: commands, defaults, choices; and everything is documented."""

from paraview import servermanager
from paraview.modules.vtkRemotingServerManager import vtkSMOrderedPropertyIterator

import lumitree.vtk
from pvtesting import PROXIES, load_plugin

# The values on the page Docs/data-model.md, by the name of the property; or of a class and its property.
CHOICES = {
    "vtkLumiShapeLight.Shape": "Sphere Disk Rectangle Tube Line",
    "Structure": "Auto BruteForce Bvh WideBvh Grid Octree KdTree BspTree Embree Cgal CgalEpick "
    "CgalCartesian",
    "Precision": "Fast Watertight Exact Automatic",
    "BvhBuild": "LongestAxisMedian BinnedSah SweepSah SpatialSplits Morton",
    "KdBuild": "SpatialMedian Sah",
    "Query": "Closest Any All Count Crossings Ties",
    "LengthUnit": "Metre Millimetre Centimetre Kilometre Inch Foot",
    "ReceiverLocation": "Points Cells",
    "SourceLocation": "Points Cells",
    "Distribution": "Cosine Uniform Normal",
    "System": "Radiometric Photometric",
    "Falloff": "CosineLobe SmoothSpot",
    "EmissionKind": "Flux AxialIntensity",
    "EmissionQuantity": "Radiance Exitance Flux",
    "LineDistribution": "Lambertian Isotropic",
    "Model": "Uniform CieOvercast CieGeneral AllWeather",
    "LevelQuantity": "ZenithRadiance HorizontalIrradiance",
    "Emission": "TotalFlux Exitance Radiance",
    "Look": "AlongRays ByDirection",
    "Mode": "ParallelGrid SphereAroundPoint Random",
    "RandomOrigins": "InBox OnSphere",
    "NodesAs": "Outlines Cells",
    "StructureFileUse": "LoadOrBuild Load Save",
    "Shape": "Sphere Ellipsoid Cylinder Cone Paraboloid Disc Plane Box Quadric Function",
    "Scene": "CornellBox Teapot City TeapotInStadium RandomCloud Sphere Torus Terrain",
}
for other in ("OtherStructure", "ReferenceStructure"):
    CHOICES[other] = CHOICES["Structure"]
CHOICES["OtherPrecision"] = CHOICES["Precision"]
CHOICES["Sweep"] = "AllStructures GridCells LeafSizes"
# A name has no domain, nor an upper limit that is infinite in C++ and cannot be written in XML.
WITHOUT_DOMAIN = {"LightName", "StructureFile"}
INFINITE = {"TMax"}
# Differs on purpose: the filter is there for the camera that the source does not have.
OTHER_DEFAULT = {("LumiCameraRaysOfScene", "AutomaticCamera")}
# What only makes sense with an input, or only without.
ELSEWHERE = {
    "LumiCameraRays": {"AutomaticCamera"},
    "LumiImplicitSurface": {"RadiusArray", "DirectionArray"},
    "LumiImplicitSurfaceAtPoints": {"Bounds", "Coefficients", "ImplicitFunction", "Step"},
}


def properties_of(proxy):
    iterator = vtkSMOrderedPropertyIterator()
    iterator.SetProxy(proxy)
    iterator.Begin()
    while not iterator.IsAtEnd():
        yield iterator.GetKey(), iterator.GetProperty()
        iterator.Next()


def check_choices(name, vtk_object, domain):
    entries = {domain.GetEntryValue(i) for i in range(domain.GetNumberOfEntries())}
    if name == "OutputPointsPrecision":
        assert entries == {0, 1, 2}
        return
    of_class = f"{vtk_object.GetClassName()}.{name}"
    chosen = CHOICES.get(of_class, CHOICES.get(name))
    constants = [getattr(vtk_object, constant) for constant in chosen.split()]
    assert constants == list(range(len(constants))), f"{name}: {constants}"
    if name == "Shape" and of_class not in CHOICES:
        entries |= set(constants[6:])  # at points there are only those with a place
    assert entries == set(constants), f"{name}: {entries}"


def check_default(proxy_name, name, prop, vtk_object):
    values = [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]
    getter = getattr(vtk_object, prop.GetCommand().replace("Set", "Get", 1))
    default = getter()
    if name in INFINITE:
        assert default == float("inf") and values[0] >= 1e299
    elif (proxy_name, name) not in OTHER_DEFAULT:
        expected = list(default) if isinstance(default, tuple) else [default if default is not None else ""]
        assert values == expected, f"{proxy_name}.{name}: {values} in XML, {expected} in C++"


def check_property(proxy_name, name, prop, vtk_object):
    where = f"{proxy_name}.{name}"
    documentation = prop.GetDocumentation()
    assert documentation and documentation.GetDescription().strip().endswith("."), f"{where} is not documented"
    assert prop.GetXMLLabel().replace(" ", "") == name, f"{where} goes by another name in Python"
    assert hasattr(vtk_object, prop.GetCommand()), f"{where}: no {prop.GetCommand()}"
    domains = prop.NewDomainIterator()
    domains.Begin()
    assert name in WITHOUT_DOMAIN or not domains.IsAtEnd(), f"{where} has no domain"
    while not domains.IsAtEnd():
        if domains.GetDomain().GetClassName() == "vtkSMEnumerationDomain":
            check_choices(name, vtk_object, domains.GetDomain())
        domains.Next()
    domains.UnRegister(None)
    if prop.GetClassName() in ("vtkSMIntVectorProperty", "vtkSMDoubleVectorProperty", "vtkSMStringVectorProperty"):
        if prop.GetCommand() != "SetInputArrayToProcess":
            check_default(proxy_name, name, prop, vtk_object)


def settable(vtk_class):
    """What has a Set and a Get method in our own classes, controllers apart."""
    ours = [base for base in vtk_class.__mro__ if base.__name__.startswith("vtkLumi")]
    names = {name for base in ours for name in base.__dict__}
    return {name[3:] for name in names if name.startswith("Set") and "Get" + name[3:] in names} - {"Controller"}


load_plugin()
manager = servermanager.ProxyManager().SMProxyManager
for group, proxy_names in PROXIES.items():
    for proxy_name in proxy_names:
        proxy = manager.GetPrototypeProxy(group, proxy_name)
        assert proxy.GetDocumentation().GetShortHelp() and proxy.GetDocumentation().GetLongHelp(), proxy_name
        menu = proxy.GetHints().FindNestedElementByName("ShowInMenu")
        assert menu.GetAttribute("category") == "Lumitree", proxy_name
        for port in range(proxy.GetNumberOfOutputPorts()):
            assert not proxy.GetOutputPortName(port).startswith("Output"), f"{proxy_name}: port {port} has no name"
        vtk_class = getattr(lumitree.vtk, proxy.GetVTKClassName())
        commands = set()
        for name, prop in properties_of(proxy):
            if prop.GetInformationOnly():
                continue
            check_property(proxy_name, name, prop, vtk_class())
            commands.add(prop.GetCommand())
        missing = {name for name in settable(vtk_class) if "Set" + name not in commands}
        missing -= ELSEWHERE.get(proxy_name, set())
        assert not missing, f"{proxy_name} lacks {missing}"
