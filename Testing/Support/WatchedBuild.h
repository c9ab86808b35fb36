// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file WatchedBuild.h
 * @brief a locator built under the eyes of an observer
 */
#ifndef skdtest_WatchedBuild_h
#define skdtest_WatchedBuild_h

#include "Support/EventCounter.h"
#include "Support/LocatorCalls.h"

namespace skdtest
{

/// A locator of a data set, and the errors and warnings of its building.
struct WatchedBuild
{
  explicit WatchedBuild(vtkDataSet* data)
    : Locator(LocatorPointer::New())
    , Events(this->Locator)
  {
    this->Locator->SetDataSet(data);
    this->Locator->BuildLocator();
  }

  LocatorPointer Locator;
  EventCounter Events;
};

}

#endif
