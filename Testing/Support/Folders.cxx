// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "Support/Folders.h"

namespace skdtest
{

std::string SourceFolder()
{
  return SKDTREE_SOURCE_DIR;
}

std::string TemporaryFolder()
{
  return SKDTREE_TEMPORARY_DIR;
}

std::string DataFolder()
{
  return SKDTREE_DATA_DIR;
}

std::string ExtraDataFolder()
{
  return SKDTREE_EXTRA_DATA_DIR;
}

}
