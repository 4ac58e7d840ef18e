// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Accel_Structures_Mailbox_h
#define Lumitree_Accel_Structures_Mailbox_h

#include "Accel/Kernel/LeafBlocks.h"
#include "Accel/Kernel/Span.h"

#include <algorithm>
#include <array>
#include <vector>

namespace lumitree
{

/// Which primitives are in which block of a structure's leaves, for walks that remember what their
/// ray has been tested against (Amanatides & Woo 1987, section 4). Empty: walks remember nothing.
class Mailbox
{
public:
  void add(const LeafBlocks& blocks, std::uint32_t firstBlock, std::uint32_t count)
  {
    const std::size_t end = firstBlock + (std::size_t{ count } + blockWidth - 1) / blockWidth;
    this->ids_.resize(std::max(this->ids_.size(), end * blockWidth), noPrimitive);
    for (std::uint32_t i = 0; i < count; ++i)
    {
      this->ids_[std::size_t{ firstBlock } * blockWidth + i] = primitiveAt(blocks, firstBlock, i);
    }
  }

  [[nodiscard]] bool empty() const { return this->ids_.empty(); }

  /// The primitives from a block on.
  [[nodiscard]] const PrimitiveId* from(std::uint32_t block) const
  {
    return this->ids_.data() + std::size_t{ block } * blockWidth;
  }

  [[nodiscard]] std::size_t memory() const { return this->ids_.capacity() * sizeof(PrimitiveId); }

private:
  std::vector<PrimitiveId> ids_;
};

/// Hands on to a visitor what has not been tested against its ray of late. A block of four takes as
/// long as one primitive, so blocks are what is left out: those at either end of a leaf of which
/// all primitives are remembered. What was tested once need not be again: candidates are kept
/// wherever they were found, and the bound only sinks. One for each ray.
template <class Visitor>
class MailboxVisitor
{
public:
  MailboxVisitor(Visitor& visitor, const Mailbox& mailbox)
    : visitor_(visitor)
    , mailbox_(mailbox)
  {
    this->tested_.fill(noPrimitive);
  }

  void node(std::uint32_t i) { this->visitor_.node(i); }
  void cell() { this->visitor_.cell(); }
  [[nodiscard]] double tStop() const { return this->visitor_.tStop(); }

  double leaf(Span span)
  {
    constexpr std::uint32_t width = blockWidth;
    const auto isTested = [this](std::uint32_t block, std::uint32_t count)
    {
      const PrimitiveId* const ids = this->mailbox_.from(block);
      return std::all_of(
        ids, ids + count, [this](PrimitiveId id) { return this->boxOf(id) == id; });
    };
    while (span.count > 0 && isTested(span.firstBlock, std::min(span.count, width)))
    {
      ++span.firstBlock;
      span.count -= std::min(span.count, width);
    }
    while (span.count > 0)
    {
      const std::uint32_t before = (span.count - 1) / width * width; // in all blocks but the last
      if (!isTested(span.firstBlock + before / width, span.count - before))
      {
        break;
      }
      span.count = before;
    }
    if (span.count == 0)
    {
      return this->visitor_.tStop();
    }
    const PrimitiveId* const ids = this->mailbox_.from(span.firstBlock);
    for (std::uint32_t i = 0; i < span.count; ++i)
    {
      this->boxOf(ids[i]) = ids[i];
    }
    return this->visitor_.leaf(span);
  }

private:
  static constexpr std::size_t boxes = 64;

  [[nodiscard]] PrimitiveId& boxOf(PrimitiveId id) { return this->tested_[id % boxes]; }

  Visitor& visitor_;
  const Mailbox& mailbox_;
  std::array<PrimitiveId, boxes> tested_; ///< by the last digits of their numbers
};

/// walk(visitor), remembering what the mailbox allows.
template <class Visitor, class Walk>
void walkWithMailbox(const Mailbox& mailbox, Visitor& visitor, const Walk& walk)
{
  if (mailbox.empty())
  {
    walk(visitor);
    return;
  }
  MailboxVisitor<Visitor> remembering(visitor, mailbox);
  walk(remembering);
}

} // namespace lumitree

#endif
