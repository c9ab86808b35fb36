// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file Folders.h
 * @brief folders of real meshes, from the configuration of the build
 */
#ifndef skdtest_Folders_h
#define skdtest_Folders_h

#include <string>

namespace skdtest
{

/// The repository.
std::string SourceFolder();

/// A folder to write to, in the build tree.
std::string TemporaryFolder();

/// The repository's Data/.
std::string DataFolder();

/// More real meshes (SKDTREE_EXTRA_DATA_DIR): it need not exist; a test that misses it is skipped.
std::string ExtraDataFolder();

}

#endif
