// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#include "CoreSupport.h"

CORETEST_INSTANTIATE_TREES(, 3);
#ifndef SKD_TEST_FEWER_KINDS
CORETEST_INSTANTIATE_TREES(, 2);
CORETEST_INSTANTIATE_TREES(, 6);
#endif
