// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "LumiPhotometricText.h"

#include "Radiometry/PhotometricFile.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <stdexcept>

namespace lumitree::filters
{

void writePhotometricFile(const PhotometricWeb& web, const std::string& fileName)
{
  std::string end = fileName.size() > 4 ? fileName.substr(fileName.size() - 4) : "";
  std::transform(end.begin(), end.end(), end.begin(),
    [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  const std::string text = end == ".ldt" ? writeEulumdat(web) : writeIes(web);
  std::ofstream file(fileName, std::ios::binary);
  file << text;
  if (!file.flush())
  {
    throw std::runtime_error("The file \"" + fileName + "\" cannot be written.");
  }
}

} // namespace lumitree::filters
