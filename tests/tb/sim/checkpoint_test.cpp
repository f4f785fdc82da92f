// State kept in a file, and files replaced at once.
#include "tb/sim/checkpoint.h"

#include <cmath>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <thread>

#include "model/core/input_error.h"
#include "tb/util/output_file.h"
#include "tb/util/read_file.h"
#include "tests/support/folder.h"

namespace cosim {
namespace {

class CheckpointIn : public test::InAFolder {
 protected:
  std::filesystem::path path_ = folder.path("state");
};

TEST_F(CheckpointIn, GivesWhatWasSavedLast) {
  Checkpoint first(path_, "work");
  EXPECT_FALSE(first.state());
  first.save({1, 2.5, "three"});
  first.save(Json{{"cases", ~std::uint64_t{0}}});
  EXPECT_EQ(Checkpoint(path_, "work").state()->json(), (Json{{"cases", ~std::uint64_t{0}}}));
}

TEST_F(CheckpointIn, HoldsNoFigureThatIsNotFinite) {
  Checkpoint kept(path_, "work");
  EXPECT_THROW(kept.save(Json{{"off", HUGE_VAL}}), std::logic_error);
  EXPECT_TRUE(folder.names().empty());
}

TEST_F(CheckpointIn, IsGoneWhenDone) {
  Checkpoint checkpoint(path_, "work");
  checkpoint.done();  // where nothing was saved
  checkpoint.save(1);
  checkpoint.done();
  EXPECT_TRUE(folder.names().empty());
}

TEST_F(CheckpointIn, IsOfItsWorkAlone) {
  Checkpoint(path_, "work").save(1);
  EXPECT_THROW(Checkpoint(path_, "wor").state(), InputError);
  EXPECT_EQ(Checkpoint(path_, "work").state()->json(), 1);
}

// Whatever is put in its place.
TEST_F(CheckpointIn, IsNoneWhereItWasChanged) {
  Checkpoint(path_, "work").save({{"cases", 3}, {"left_out", {1, 2}}});
  const Json whole = Json::parse(read_file(path_));
  const auto refused = [&](const Json& changed) {
    write_file(path_, changed.dump());
    EXPECT_THROW(Checkpoint(path_, "work").state(), InputError) << changed;
  };
  for (const char* key : {"work", "hash", "state"}) {
    Json changed = whole;
    changed.erase(key);
    refused(changed);
    for (const Json& other : {Json(), Json(7), Json("x"), Json::array(), Json::object()}) {
      changed[key] = other;
      refused(changed);
    }
  }
  Json longer = whole;
  longer["state"]["left_out"] = std::vector<int>(100'000);
  refused(longer);
}

TEST_F(CheckpointIn, IsDueAfterAWhileAndNeverWithoutAFile) {
  Checkpoint none("", "work"), kept(path_, "work");
  std::this_thread::sleep_for(std::chrono::milliseconds(150));
  EXPECT_TRUE(kept.due());
  EXPECT_FALSE(none.due());
  none.save(1);
  none.done();
  EXPECT_FALSE(none.state());
}

// A reader at any moment sees the whole of one text.
TEST_F(CheckpointIn, ReplacesFilesAtOnce) {
  const std::string a(100'000, 'a'), b(70'000, 'b');
  write_file(path_, a);
  std::jthread writer([&](const std::stop_token& stop) {
    while (!stop.stop_requested()) {
      write_file(path_, b);
      write_file(path_, a);
    }
  });
  for (int i = 0; i < 2000; ++i) {
    const std::string text = read_file(path_);
    ASSERT_TRUE(text == a || text == b) << text.size();
  }
}

TEST_F(CheckpointIn, LeavesTheOldFileWhereItCannotReplaceIt) {
  std::filesystem::create_directory(path_);
  EXPECT_THROW(write_file(path_, "text"), InputError);
  EXPECT_THROW(write_file(folder.path("none/file"), "text"), InputError);
  EXPECT_THROW(read_file(folder.path("none")), InputError);
  EXPECT_TRUE(std::filesystem::is_directory(path_));
  std::filesystem::remove(path_);
  EXPECT_TRUE(folder.names().empty());
}

}  // namespace
}  // namespace cosim
