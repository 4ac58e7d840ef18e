// SPDX-FileCopyrightText: Copyright (c) The Lumitree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef Lumitree_Radiometry_Looking_PartOfJob_h
#define Lumitree_Radiometry_Looking_PartOfJob_h

#include "Accel/Query.h"

namespace lumitree
{

/// A part of a job that tells how far the whole is.
class PartOfJob
{
public:
  PartOfJob(JobControl* whole, double begin, double end)
  {
    if (whole)
    {
      this->control_.onProgress = [whole, begin, end](double done) {
        return !whole->stop &&
          (!whole->onProgress || whole->onProgress(begin + done * (end - begin)));
      };
    }
  }
  JobControl* operator*() { return &this->control_; }

private:
  JobControl control_;
};

} // namespace lumitree

#endif
