// SPDX-License-Identifier: MIT
// Playback under a clock of the test's own: viewport and camera view both show the flight's frame
// for each time, however late the pictures come.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "app/drive/player.hpp"
#include "host/open_host.hpp"

namespace vides {
namespace {

constexpr double kFrameRate = 25.0;

// Both pictures of a display frame, without what stands around them.
struct Pictures {
  Picture viewport, camera;
  bool operator==(const Pictures&) const = default;
};

Picture cut(const Picture& from, const Rect& rect) {
  Picture part(static_cast<int>(rect.width), static_cast<int>(rect.height));
  for (int y = 0; y < part.height; ++y) {
    for (int x = 0; x < part.width; ++x) {
      const auto pixel = from.pixel(static_cast<int>(rect.x) + x, static_cast<int>(rect.y) + y);
      std::ranges::copy(pixel, part.pixel(x, y).begin());
    }
  }
  return part;
}

// An editor whose clock the test moves.
class Cinema {
 public:
  Cinema() {
    OffscreenOptions options;
    options.size = {960, 600};
    auto host = openOffscreen(OffscreenKind::kOsmesa, options);
    EXPECT_TRUE(host) << host.error();
    host_ = std::move(*host);
    auto player = Player::create(*host_);
    EXPECT_TRUE(player) << player.error();
    player_ = std::move(*player);
    run("open \"" VIDES_SOURCE_DIR "/assets/flights/pyramid.vid\"");
    // Nothing else is to change from display frame to display frame.
    for (int i = 0; i < 5; ++i) player_->frame();
  }

  void run(const std::string& line) { ASSERT_TRUE(player_->perform(*parseCommand(line))) << line; }
  const Session& session() const { return player_->editor().session(); }
  double now() const { return host_->time(); }
  bool wantsFrame() const { return player_->wantsFrame(); }

  // The display frame at a time not before the last one.
  Pictures at(double time) {
    host_->advanceTime(std::max(0.0, time - host_->time()));
    const auto picture = player_->picture();
    EXPECT_TRUE(picture) << picture.error();
    const Widget* const film = player_->editor().widgets().find("camera/picture");
    return {cut(*picture, player_->editor().viewport()), cut(*picture, film->rect)};
  }

 private:
  std::unique_ptr<OffscreenHost> host_;
  std::unique_ptr<Player> player_;
};

// What a frame looks like where the playhead was put there by hand; the camera is the flight's.
class Frames {
 public:
  Pictures of(std::int64_t frame) {
    cinema_.run("go-to-frame " + std::to_string(frame));
    const Session& session = cinema_.session();
    const Camera shown = session.camera(), wanted = session.evaluation().frame(frame).camera;
    EXPECT_EQ(shown.viewReferencePoint, wanted.viewReferencePoint);
    EXPECT_EQ(shown.viewPlaneNormal, wanted.viewPlaneNormal);
    EXPECT_EQ(shown.viewUpVector, wanted.viewUpVector);
    EXPECT_EQ(shown.zoom, wanted.zoom);
    return cinema_.at(cinema_.now());
  }

 private:
  Cinema cinema_;
};

void expectShows(const Pictures& pictures, Frames& frames, std::int64_t frame) {
  const Pictures wanted = frames.of(frame);
  EXPECT_TRUE(pictures.viewport == wanted.viewport) << "the viewport, frame " << frame;
  EXPECT_TRUE(pictures.camera == wanted.camera) << "the camera view, frame " << frame;
}

TEST(PlaybackPictures, TellFramesApart) {
  Frames frames;
  // Else the tests below would see nothing.
  const Pictures one = frames.of(100);
  for (const std::int64_t other : {99, 101}) {
    const Pictures beside = frames.of(other);
    EXPECT_FALSE(one.viewport == beside.viewport) << other;
    EXPECT_FALSE(one.camera == beside.camera) << other;
  }
  EXPECT_TRUE(one == frames.of(100));
}

TEST(PlaybackPictures, BothShowTheFrameOfTheTimeHoweverLateTheyCome) {
  Cinema cinema;
  Frames frames;
  cinema.run("play on");
  const double start = cinema.now();
  // Sooner than the next frame, on the dot, and far too late: frames are dropped, time goes on.
  std::mt19937 engine(7);
  std::uniform_real_distribution<double> share(0.0, 1.0);
  double since = 0.0;
  for (int i = 0; i < 24; ++i) {
    since += i % 4 == 3 ? 2.0 * share(engine) : 0.08 * share(engine);
    if (i % 4 == 2) since = std::ceil(since * kFrameRate) / kFrameRate;
    const Pictures seen = cinema.at(start + since);
    const auto frame = static_cast<std::int64_t>(std::floor(since * kFrameRate + 1e-6));
    EXPECT_EQ(cinema.session().frame(), frame) << since;
    expectShows(seen, frames, frame);
    EXPECT_TRUE(cinema.wantsFrame());
  }
}

TEST(PlaybackPictures, TheLastFrameStays) {
  Cinema cinema;
  Frames frames;
  const std::int64_t last = cinema.session().evaluation().frameCount() - 1;
  cinema.run("go-to-frame " + std::to_string(last - 10));
  cinema.run("play on");
  const double start = cinema.now();
  expectShows(cinema.at(start + 9.9 / kFrameRate), frames, last - 1);
  EXPECT_TRUE(cinema.session().playback().playing());
  expectShows(cinema.at(start + 3600.0), frames, last);
  EXPECT_FALSE(cinema.session().playback().playing());
  expectShows(cinema.at(start + 7200.0), frames, last);
}

TEST(PlaybackPictures, ALoopBeginsAgainWithoutLosingTime) {
  Cinema cinema;
  Frames frames;
  const std::int64_t count = cinema.session().evaluation().frameCount();
  cinema.run("loop on");
  cinema.run("play on");
  const double start = cinema.now();
  for (const std::int64_t n : {count - 1, count, count + 57, 5 * count + 300}) {
    expectShows(cinema.at(start + (static_cast<double>(n) + 0.5) / kFrameRate), frames, n % count);
  }
  EXPECT_TRUE(cinema.session().playback().playing());
}

TEST(PlaybackPictures, WhereThePlayheadIsPutItGoesOn) {
  Cinema cinema;
  Frames frames;
  cinema.run("play on");
  cinema.at(cinema.now() + 1.0);
  cinema.run("go-to-frame 400");
  const double start = cinema.now();
  expectShows(cinema.at(start + 10.5 / kFrameRate), frames, 410);
  // Stopped it stays, whatever the time.
  cinema.run("play off");
  const std::int64_t frame = cinema.session().frame();
  expectShows(cinema.at(start + 60.0), frames, frame);
}

}  // namespace
}  // namespace vides
