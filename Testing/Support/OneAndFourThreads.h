// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OneAndFourThreads.h
 * @brief the same run by one thread and by four
 */
#ifndef skdtest_OneAndFourThreads_h
#define skdtest_OneAndFourThreads_h

#include "vtkSMPTools.h"

#include <string>
#include <utility>

namespace skdtest
{

/// `run()` of one thread and of four, whatever the number of processors.
template <class Run>
auto OneAndFourThreads(const Run& run)
{
  const std::string former = vtkSMPTools::GetBackend();
  vtkSMPTools::SetBackend("STDThread");
  vtkSMPTools::Initialize(1);
  auto one = run();
  vtkSMPTools::Initialize(4);
  auto four = run();
  vtkSMPTools::Initialize(0);
  vtkSMPTools::SetBackend(former.c_str());
  return std::make_pair(std::move(one), std::move(four));
}

}

#endif
