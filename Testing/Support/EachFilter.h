// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
/**
 * @file EachFilter.h
 * @brief the fixture of tests that run over all filters in their usual set-ups
 */
#ifndef skdtest_EachFilter_h
#define skdtest_EachFilter_h

#include "Support/FilterZoo.h"
#include "Support/QuietWindow.h"

#include <gtest/gtest.h>

namespace skdtest
{

class EachFilter : public testing::TestWithParam<std::size_t>
{
protected:
  const FilterSetup& Setup = AllFilterSetups()[GetParam()];
  QuietWindow Quiet;
};

}

#endif
