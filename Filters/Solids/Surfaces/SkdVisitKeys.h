// SPDX-FileCopyrightText: Copyright (c) the skD-tree authors
// SPDX-License-Identifier: BSD-3-Clause
#ifndef SkdVisitKeys_h
#define SkdVisitKeys_h

#include "Exchange/SkdTransport.h"

#include <algorithm>

namespace skdtree
{
/// Where questions are: of which process, and which one.
struct SkdAsked
{
  std::size_t Process;
  std::size_t Number;
};

/// Calls visit(first, last) for the questions of each key, those of a key as `isBefore` says and by
/// process.
template <class Question, class IsBefore, class Visit>
void SkdVisitKeys(
  const SkdRowsByProcess<Question>& questions, const IsBefore& isBefore, const Visit& visit)
{
  std::vector<SkdAsked> all;
  for (std::size_t process = 0; process < questions.size(); ++process)
  {
    for (std::size_t i = 0; i < questions[process].size(); ++i)
    {
      all.push_back({ process, i });
    }
  }
  const auto at = [&questions](const SkdAsked& asked) -> const Question&
  { return questions[asked.Process][asked.Number]; };
  std::stable_sort(all.begin(), all.end(),
    [&](const SkdAsked& a, const SkdAsked& b)
    { return at(a).Key != at(b).Key ? at(a).Key < at(b).Key : isBefore(at(a), at(b)); });
  for (auto first = all.begin(); first != all.end();)
  {
    const auto last = std::find_if(
      first, all.end(), [&](const SkdAsked& asked) { return at(asked).Key != at(*first).Key; });
    visit(first, last);
    first = last;
  }
}
}

#endif
