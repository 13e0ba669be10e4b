// SPDX-License-Identifier: Apache-2.0
#include "sample_output.h"

#include <cstddef>
#include <utility>

#include "nazori/recording/sample_csv.h"

namespace nazori::cli {
namespace {

constexpr std::size_t kSendAt = std::size_t{1} << 20;

}  // namespace

SampleOutput::SampleOutput(std::optional<base::OutputFile> file, Console* console)
    : file_(std::move(file)), console_(console), text_(recording::kSampleCsvHeader) {
  text_.reserve(kSendAt + 1024);
}

base::Result<SampleOutput> SampleOutput::to_file(const std::string& path) {
  auto file = base::OutputFile::create(path);
  if (!file) return tl::unexpected(std::move(file.error()));
  return SampleOutput(std::move(*file), nullptr);
}

base::Result<SampleOutput> SampleOutput::to_console(Console& console) {
  return SampleOutput(std::nullopt, &console);
}

base::Result<void> SampleOutput::add(const haptics::ServoSample& sample) {
  recording::append_csv_row(text_, sample);
  return text_.size() < kSendAt ? base::Result<void>() : send();
}

base::Result<void> SampleOutput::send() {
  base::Result<void> sent;
  if (file_) {
    sent = file_->append(text_);
  } else {
    console_->print_file(text_);
  }
  text_.clear();
  return sent;
}

base::Result<void> SampleOutput::commit() {
  if (auto sent = send(); !sent) return sent;
  return file_ ? file_->commit() : base::Result<void>();
}

}  // namespace nazori::cli
