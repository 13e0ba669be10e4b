// SPDX-License-Identifier: Apache-2.0
#include <array>
#include <string>
#include <vector>

#include "nazori/base/file.h"
#include "nazori/recording/sample_csv.h"
#include "nazori/recording/session_recorder.h"

namespace nazori::recording {

base::Result<RecordingEnd> export_csv(const std::filesystem::path& recording,
                                      const std::filesystem::path& csv, const base::Progress& progress) {
  auto reader = RecordingReader::open(recording);
  if (!reader) return tl::unexpected(std::move(reader.error()));
  auto file = base::OutputFile::create(csv);
  if (!file) return tl::unexpected(std::move(file.error()));
  std::string text(kSampleCsvHeader);
  std::vector<haptics::ServoSample> samples(4096);
  for (;;) {
    const auto count = reader->read(samples);
    if (!count) return tl::unexpected(count.error());
    for (std::size_t i = 0; i < *count; ++i) append_csv_row(text, samples[i]);
    if (auto written = file->append(text); !written) return tl::unexpected(std::move(written.error()));
    text.clear();
    if (*count == 0) break;
    if (progress && !progress(reader->progress(), "exporting"))
      return base::fail(base::Errc::cancelled, "stopped", csv.string());
  }
  if (auto done = file->commit(); !done) return tl::unexpected(std::move(done.error()));
  return reader->end();
}

}  // namespace nazori::recording
