// SPDX-License-Identifier: Apache-2.0
#include "nazori/exchange/tablets.h"

#include <gtest/gtest.h>

#include "nazori/exchange/recordings.h"

namespace nazori::exchange {
namespace {

using json::to_line;

kanji::Character rest() {
  kanji::Character character;
  character.code_point = U'休';
  character.variant = "Kaisho";
  character.strokes.resize(6);
  return character;
}

TEST(TabletDocument, NamesTheFilesOfACarvedCharacter) {
  EXPECT_EQ(to_line(to_json(rest(), CarvedFiles{"a.raw", std::nullopt, 128})),
            R"({"character":"休","code_point":"U+4F11","variant":"Kaisho","file":"a.raw","size":128,)"
            R"("strokes_file":null,"stroke_count":6})");
  EXPECT_EQ(to_json(rest(), CarvedFiles{"a.raw", "a.str", 128})["strokes_file"], "a.str");
  EXPECT_EQ(to_line(to_json(PaintedPicture{"休", "b.png", 64, 32})),
            R"({"subject":"休","file":"b.png","width":64,"height":32})");
}

TEST(TabletDocument, OfAFollowedTabletWeighsTheDistancesByTheTimeOfContact) {
  devices::HandReport hand;
  hand.strokes.resize(2);
  hand.strokes[0].stroke = 1;
  hand.strokes[0].duration_s = 1;
  hand.strokes[0].contact_share = 1;
  hand.strokes[0].tip_rms_m = 0.003;
  hand.strokes[0].tip_max_m = 0.02;
  hand.strokes[1].duration_s = 6;
  hand.strokes[1].contact_share = 0.5;
  hand.strokes[1].tip_rms_m = 0.001;
  hand.strokes[1].tip_max_m = 0.01;
  hand.work_on_hand_j = -0.25;
  EXPECT_NEAR(tracking_of(hand).rms_m, 0.0017320508075688772, 1e-15);  // sqrt((9 + 3) / 4) mm
  EXPECT_EQ(tracking_of(hand).max_m, 0.02);
  EXPECT_EQ(tracking_of({}).rms_m, 0);
  Value json = to_json(rest(), {"Touch", 1000, true, "d.png", false}, hand, {});
  EXPECT_EQ(json["device"], "Touch");
  EXPECT_EQ(json["snapping"], true);
  EXPECT_EQ(json["dissipated_j"], 0.25);
  EXPECT_EQ(json["strokes"].size(), 2U);
  EXPECT_EQ(json["strokes"][0]["tip_max_m"], 0.02);
  EXPECT_FALSE(json.contains("timing"));
  hand.clock.real_time = true;
  hand.clock.missed = 3;
  json = to_json(rest(), {"Touch", 1000, true, "d.png", true}, hand, {});
  EXPECT_EQ(json["timing"]["scheduling"], "SCHED_FIFO");
  EXPECT_EQ(json["timing"]["skipped_periods"], 3);
}

TEST(TabletDocument, OfAFeltMotionSaysHowMuchFasterThanTheHandItWasComputed) {
  FeltMotion felt{"休", "snap", "Touch", 1000, "in.csv", "out.csv", {}, {}, 2};
  felt.samples.samples = 5000;
  felt.timing.late_ticks = 4;
  EXPECT_EQ(felt.real_time_factor(), 2.5);
  const Value json = to_json(felt);
  EXPECT_EQ(json["ticks"], 5000);
  EXPECT_EQ(json["late_ticks"], 4);
  EXPECT_EQ(json["real_time_factor"], 2.5);
  EXPECT_EQ(json["output"], "out.csv");
  felt.took_s = 0;
  EXPECT_EQ(felt.real_time_factor(), 0);
}

TEST(RecordingDocument, SaysInWhichStateTheRecordingIs) {
  ReadRecording read;
  read.session.device = {"Touch", 1000, true, {}};
  read.session.start_ns = 1'767'323'045'900'000'000;
  EXPECT_EQ(read.start(), "2026-01-02T03:04:05Z");
  EXPECT_EQ(read.state(), "incomplete");
  read.recovery = recording::Recovery::in_progress;
  EXPECT_EQ(read.state(), "being recorded");
  read.end.finished = true;
  EXPECT_EQ(read.state(), "complete");
  read.end.recovered = true;
  EXPECT_EQ(read.state(), "recovered");
  EXPECT_EQ(read.max_lateness_s(), 0);
  read.samples.longest_period_s = 0.0035;
  EXPECT_NEAR(read.max_lateness_s(), 0.0025, 1e-12);
  read.gaps = 7;
  const Value json = to_json(read, "s.nzr");
  EXPECT_EQ(json["file"], "s.nzr");
  EXPECT_EQ(json["state"], "recovered");
  EXPECT_EQ(json["gaps"], 7);
  EXPECT_EQ(json["ticks"], 0);
  recording::RecordingEnd end;
  end.samples = 9;
  end.finished = true;
  EXPECT_EQ(to_line(exported_recording(end, "s.csv")),
            R"({"file":"s.csv","ticks":9,"damaged":0,"finished":true})");
}

}  // namespace
}  // namespace nazori::exchange
