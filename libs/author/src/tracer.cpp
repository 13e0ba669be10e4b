// SPDX-License-Identifier: Apache-2.0
#include "nazori/author/tracer.h"

#include <utility>

#include "nazori/author/font_picture.h"
#include "nazori/author/stroke_edits.h"
#include "nazori/author/trace.h"
#include "nazori/scan/picture.h"

namespace nazori::author {
namespace {

base::Result<scan::Photo> picture_of(const TraceRequest& request) {
  return request.picture.empty() ? font_picture(request.glyph, request.family)
                                 : scan::load_photo(request.picture);
}

}  // namespace

base::Result<Traced> trace_request(const TraceRequest& request) {
  Traced found;
  found.source = request.picture.empty() ? request.family : request.picture.filename().string();
  const auto failed = [&](base::Error error) {
    if (error.where.empty()) error.where = found.source;
    return tl::unexpected(std::move(error));
  };
  const auto picture = picture_of(request);
  if (!picture) return failed(picture.error());
  if (request.known.empty()) {
    auto strokes = trace(*picture);
    if (!strokes) return failed(strokes.error());
    for (OwnStroke& stroke : *strokes) found.strokes.push_back(thinned(std::move(stroke)));
    return found;
  }
  auto fitted = trace_as(*picture, request.known);
  if (!fitted) return failed(fitted.error());
  for (std::size_t i = 0; i < fitted->size(); ++i) {
    if ((*fitted)[i].covered < kSureShare) found.unsure.push_back(i);
    found.strokes.push_back(thinned(std::move((*fitted)[i].stroke)));
  }
  return found;
}

void Tracer::trace(TraceRequest request) {
  if (!work_)
    work_.emplace(
        "tracing", inbox_, [](const TraceRequest& asked, const auto&) { return trace_request(asked); },
        [this](const base::Result<Traced>& answer) {
          if (answer)
            traced(*answer);
          else
            failed(answer.error());
        });
  work_->request(std::move(request));
}

}  // namespace nazori::author
