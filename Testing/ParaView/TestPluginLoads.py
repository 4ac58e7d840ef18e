# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""The plugin loads, and every proxy of it makes its VTK object."""

from paraview import servermanager

from pvtesting import PROXIES, load_plugin

load_plugin()
manager = servermanager.ProxyManager().SMProxyManager
for group, names in PROXIES.items():
    for name in names:
        proxy = manager.NewProxy(group, name)
        proxy.UpdateVTKObjects()
        vtk_object = proxy.GetClientSideObject()
        assert vtk_object, f"{name} has no VTK object"
        assert vtk_object.GetClassName() == proxy.GetVTKClassName()
        proxy.UnRegister(None)
