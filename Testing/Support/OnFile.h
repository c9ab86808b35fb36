// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file OnFile.h
 * @brief the fixture of tests of each of some files
 */
#ifndef skdtest_OnFile_h
#define skdtest_OnFile_h

#include "Support/Folders.h"
#include "Support/RealMeshes.h"

#include <gtest/gtest.h>

namespace skdtest
{

/// Skipped where there is no file. A SetUp() of a derived class begins with this one, and ends if
/// IsSkipped().
class OnFile : public testing::TestWithParam<std::string>
{
protected:
  void SetUp() override
  {
    if (GetParam().empty())
    {
      GTEST_SKIP() << "no such files in " << ExtraDataFolder();
    }
  }
};

}

#endif
