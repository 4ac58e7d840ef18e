# SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
# SPDX-License-Identifier: BSD-3-Clause
"""Writes the tables of properties on the pages of Docs/filters from what ParaView knows about the proxies.

PV_PLUGIN_PATH=<where the plugin Lumitree is> pvpython Docs/property_tables.py

A table stands below a line ``<!-- properties of PROXY -->`` and ends at the next empty line.
"""

from __future__ import annotations

import re
from pathlib import Path

from paraview import servermanager, simple  # noqa: F401  simple connects to the built-in server
from paraview.modules.vtkRemotingServerManager import vtkSMOrderedPropertyIterator

PAGES = Path(__file__).resolve().parent / "filters"
MARK = re.compile(r"(<!-- properties of (\w+) -->\n\n).*?(?=\n\n|\n\Z)", re.DOTALL)


def properties_of(proxy) -> list:
    """Names and properties that are no input and can be shown, those first that need no asking for advanced ones."""
    iterator = vtkSMOrderedPropertyIterator()
    iterator.SetProxy(proxy)
    iterator.Begin()
    found = []
    while not iterator.IsAtEnd():
        prop = iterator.GetProperty()
        shown = not prop.GetInformationOnly() and prop.GetPanelVisibility() != "never"
        if shown and not prop.IsA("vtkSMInputProperty"):
            found.append((iterator.GetKey(), iterator.GetProperty()))
        iterator.Next()
    return sorted(found, key=lambda item: item[1].GetPanelVisibility() != "default")


def domains_of(prop) -> list:
    iterator = prop.NewDomainIterator()
    iterator.Begin()
    found = []
    while not iterator.IsAtEnd():
        found.append(iterator.GetDomain())
        iterator.Next()
    iterator.UnRegister(None)
    return found


def default_and_range(prop) -> tuple[str, str]:
    if prop.IsA("vtkSMProxyProperty"):
        return "", "one of the list"
    values = [prop.GetElement(i) for i in range(prop.GetNumberOfElements())]
    if prop.GetCommand() == "SetInputArrayToProcess":
        return values[-1], "arrays of vectors"
    allowed = ""
    for domain in domains_of(prop):
        if domain.IsA("vtkSMEnumerationDomain"):
            texts = {domain.GetEntryValue(i): domain.GetEntryText(i) for i in range(domain.GetNumberOfEntries())}
            if domain.IsA("vtkSMBooleanDomain"):
                texts = {0: "off", 1: "on"}
            return texts[values[0]], ", ".join(f"{text} {value}" for value, text in sorted(texts.items()))
        if domain.IsA("vtkSMBooleanDomain"):
            return ("on" if values[0] else "off"), "off 0, on 1"
        if domain.IsA("vtkSMIntRangeDomain") or domain.IsA("vtkSMDoubleRangeDomain"):
            lowest = f"{domain.GetMinimum(0):g}" if domain.GetMinimumExists(0) else ""
            highest = f"{domain.GetMaximum(0):g}" if domain.GetMaximumExists(0) else ""
            allowed = f"{lowest} … {highest}" if highest else f"≥ {lowest}" if lowest else ""
    return " ".join(f"{value:g}" if not isinstance(value, str) else value for value in values), allowed


def table_of(proxy_name: str) -> str:
    manager = servermanager.ProxyManager().SMProxyManager
    group = "sources" if manager.HasDefinition("sources", proxy_name) else "filters"
    proxy = manager.GetPrototypeProxy(group, proxy_name)
    rows = ["| property | default | range | meaning |", "| --- | --- | --- | --- |"]
    for name, prop in properties_of(proxy):
        meaning = " ".join(prop.GetDocumentation().GetDescription().split())
        rows.append("| " + " | ".join((f"`{name}`", *default_and_range(prop), meaning)) + " |")
    return "\n".join(rows)


def with_tables(text: str) -> str:
    return MARK.sub(lambda mark: mark.group(1) + table_of(mark.group(2)), text)


if __name__ == "__main__":
    for page in sorted(PAGES.glob("*.md")):
        page.write_text(with_tables(page.read_text(encoding="utf-8")), encoding="utf-8")
