// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Accel/Save.h"

#include "Accel/FloatEnvironment.h"
#include "Accel/Registry.h"
#include "Accel/Save/SaveStream.h"

#include <boost/crc.hpp>

#include <cerrno>
#include <cstdio>
#include <fstream>
#include <istream>
#include <ostream>

namespace lumitree
{
namespace
{

constexpr std::string_view magic = "LumiTree";
/// Read by a machine of the other byte order it is 0x04030201.
constexpr std::uint32_t byteOrderMark = 0x01020304;
constexpr std::size_t headerSize = 8 + 4 + 4 + 8;
constexpr std::size_t readAtOnce = 1 << 20;

std::uint32_t checksumOf(std::string_view header, std::string_view body)
{
  boost::crc_32_type crc;
  crc.process_bytes(header.data(), header.size());
  crc.process_bytes(body.data(), body.size());
  return crc.checksum();
}

std::string headerFor(std::size_t bodySize)
{
  SaveWriter header;
  header.append(magic.data(), magic.size());
  header.put(byteOrderMark);
  header.put(saveVersion);
  header.put(std::uint64_t{ bodySize });
  return header.bytes();
}

std::uint64_t bodySizeFrom(const std::string& header)
{
  require(header.size() >= magic.size() && std::string_view(header).substr(0, 8) == magic,
    "it is no saved structure");
  SaveReader reader(std::string_view(header).substr(magic.size()));
  require(reader.get<std::uint32_t>() == byteOrderMark,
    "it was written on a machine that orders bytes the other way");
  const auto version = reader.get<std::uint32_t>();
  if (version != saveVersion)
  {
    throw SaveError(
      "it is of version " + std::to_string(version) + ", not " + std::to_string(saveVersion));
  }
  return reader.get<std::uint64_t>();
}

/// Up to so many bytes: memory is taken as they come, whatever number is asked for.
std::string readUpTo(std::istream& stream, std::uint64_t size)
{
  std::string bytes;
  while (bytes.size() < size && stream)
  {
    const std::size_t had = bytes.size();
    bytes.resize(had + static_cast<std::size_t>(std::min<std::uint64_t>(readAtOnce, size - had)));
    stream.read(bytes.data() + had, static_cast<std::streamsize>(bytes.size() - had));
    bytes.resize(had + static_cast<std::size_t>(stream.gcount()));
  }
  return bytes;
}

std::string readBody(std::istream& stream)
{
  const std::string header = readUpTo(stream, headerSize);
  const std::uint64_t size = bodySizeFrom(header);
  std::string body = readUpTo(stream, size);
  const std::string end = readUpTo(stream, sizeof(std::uint32_t));
  require(body.size() == size, "it ends too early");
  SaveReader checksum(end);
  require(checksum.get<std::uint32_t>() == checksumOf(header, body),
    "it is damaged: its checksum does not fit");
  require(stream.peek() == std::istream::traits_type::eof(), "something follows after its end");
  return body;
}

void putOptions(const BuildOptions& options, SaveWriter& writer)
{
  writer.put(static_cast<std::int32_t>(options.structure));
  writer.put(static_cast<std::int32_t>(options.bvhBuild));
  writer.put(static_cast<std::int32_t>(options.kdBuild));
  writer.put(static_cast<std::int32_t>(options.leafSize));
  writer.put(static_cast<std::int32_t>(options.maxDepth));
  writer.put(options.gridDensity);
  for (const int cells : options.gridResolution)
  {
    writer.put(static_cast<std::int32_t>(cells));
  }
  writer.put(static_cast<std::uint8_t>(options.mailboxing ? 1 : 0));
}

BuildOptions getOptions(SaveReader& reader)
{
  BuildOptions options;
  const auto structure = reader.get<std::int32_t>();
  require(structure > 0 && structure < structureCount, "it names a structure that there is not");
  options.structure = static_cast<Structure>(structure);
  options.bvhBuild = static_cast<BvhBuild>(reader.get<std::int32_t>());
  options.kdBuild = static_cast<KdBuild>(reader.get<std::int32_t>());
  options.leafSize = reader.get<std::int32_t>();
  options.maxDepth = reader.get<std::int32_t>();
  options.gridDensity = reader.get<double>();
  for (int& cells : options.gridResolution)
  {
    cells = reader.get<std::int32_t>();
  }
  const auto mailboxing = reader.get<std::uint8_t>();
  require(mailboxing <= 1, "it neither remembers nor does not");
  options.mailboxing = mailboxing == 1;
  requireValid(options);
  return options;
}

std::shared_ptr<const Accelerator> fromBody(
  const std::string& body, std::shared_ptr<const Surface> surface, int threads, JobControl* control)
{
  SaveReader reader(body);
  BuildOptions options = getOptions(reader);
  options.threads = threads;
  const std::vector<std::uint8_t> of = reader.getAll<std::uint8_t>(Fingerprint{}.size());
  const Fingerprint fingerprint = fingerprintOf(*surface, threads);
  if (!std::equal(of.begin(), of.end(), fingerprint.begin()))
  {
    throw WrongSurface("it is of another surface");
  }
  // References may be missing in this build.
  const Registry& registry = Registry::instance();
  const Backend backend =
    registry.has(options.structure) ? registry.find(options.structure) : Backend{};
  require(static_cast<bool>(backend.load), "its structure is never saved");
  return backend.load(std::move(surface), options, reader, control);
}

} // namespace

void save(const Accelerator& accelerator, std::ostream& stream)
{
  SaveWriter body;
  putOptions(accelerator.options(), body);
  const Fingerprint fingerprint =
    fingerprintOf(accelerator.surface(), accelerator.options().threads);
  body.append(fingerprint.data(), fingerprint.size());
  if (!accelerator.saveTo(body))
  {
    throw SaveError("structure '" + std::string(name(accelerator.options().structure)) +
      "' keeps its tree to itself: it cannot be saved");
  }
  const std::string header = headerFor(body.bytes().size());
  const std::uint32_t checksum = checksumOf(header, body.bytes());
  stream.write(header.data(), static_cast<std::streamsize>(header.size()));
  stream.write(body.bytes().data(), static_cast<std::streamsize>(body.bytes().size()));
  stream.write(reinterpret_cast<const char*>(&checksum), sizeof(checksum));
  stream.flush();
  require(static_cast<bool>(stream), "the structure could not be written");
}

void saveFile(const Accelerator& accelerator, const std::string& path)
{
  const std::string part = path + ".part";
  const auto fail = [&](const std::string& what)
  {
    const std::string reason = errno != 0 ? std::string(": ") + std::strerror(errno) : "";
    std::remove(part.c_str());
    throw SaveError(what + " '" + path + "'" + reason);
  };
  errno = 0;
  {
    std::ofstream file(part, std::ios::binary);
    if (!file)
    {
      fail("cannot write");
    }
    try
    {
      save(accelerator, file);
    }
    catch (const SaveError&)
    {
      if (!file)
      {
        fail("cannot write");
      }
      file.close();
      std::remove(part.c_str());
      throw;
    }
  }
  if (std::rename(part.c_str(), path.c_str()) != 0)
  {
    fail("cannot write");
  }
}

std::shared_ptr<const Accelerator> load(
  std::istream& stream, std::shared_ptr<const Surface> surface, int threads, JobControl* control)
{
  if (!surface)
  {
    throw std::invalid_argument("there is no surface to load a structure over");
  }
  const FloatEnvironment environment;
  const std::string body = readBody(stream);
  try
  {
    return fromBody(body, std::move(surface), threads, control);
  }
  // Numbers that no builder takes.
  catch (const std::logic_error& error)
  {
    throw SaveError(error.what());
  }
}

std::shared_ptr<const Accelerator> loadFile(
  const std::string& path, std::shared_ptr<const Surface> surface, int threads, JobControl* control)
{
  errno = 0;
  std::ifstream file(path, std::ios::binary);
  if (!file)
  {
    throw SaveError("cannot read '" + path + "': " + std::strerror(errno));
  }
  try
  {
    return load(file, std::move(surface), threads, control);
  }
  catch (const WrongSurface& error)
  {
    throw WrongSurface("'" + path + "' cannot be loaded: " + error.what());
  }
  catch (const SaveError& error)
  {
    throw SaveError("'" + path + "' cannot be loaded: " + error.what());
  }
}

bool isSavedStructure(const std::string& path)
{
  std::ifstream file(path, std::ios::binary);
  return file && readUpTo(file, magic.size()) == magic;
}

} // namespace lumitree
