#include "mesher/io/evolution.h"

#include <catch2/catch.hpp>
#include <filesystem>

#include "mesher/errors.h"
#include "mesher/generate.h"
#include "tests/support/domains.h"
#include "tests/support/meshes.h"
#include "tests/support/temporary_folder.h"

using namespace parmesan;

TEST_CASE("an evolution is a page, a list and frames that grow to the last mesh", "[mesher][io]") {
  const support::TemporaryFolder folder;
  EvolutionWriter writer(folder / "frames");
  GenerateOptions options;
  options.schedule = GENERATE(Schedule::Thesis, Schedule::Fast);
  options.observer = [&](const ParticleSystem& particles, std::int64_t step) { writer.see(particles, step); };
  const Mesh last = generate(support::unit_square(), ConstantField(Metric::isotropic(0.1)), options).mesh;
  writer.finish(last);
  const std::string page = support::content_of(folder / "frames/index.html");
  const std::string list = support::content_of(folder / "frames/evolution.pvd");
  CHECK_THAT(page, Catch::EndsWith("</html>\n"));
  CHECK(page.find("http") == std::string::npos);  // self-contained
  std::size_t frames = 0;
  for (std::size_t at = page.find("{s:"); at != std::string::npos; at = page.find("{s:", at + 1)) ++frames;
  std::size_t files = 0;
  for (const auto& entry : std::filesystem::directory_iterator(folder / "frames"))
    files += entry.path().extension() == ".vtu" ? 1 : 0;
  CHECK(frames == files);
  CHECK(frames >= 2);
  CHECK(frames < 200);
  CHECK_THAT(list, Catch::Contains("frame_000.vtu"));
}

TEST_CASE("a folder for an evolution that cannot be made is an error", "[mesher][io][errors]") {
  const support::TemporaryFolder folder;
  const std::string file = folder.write("file", "x");
  CHECK_THROWS_AS(EvolutionWriter(file + "/frames"), FileError);
}

TEST_CASE("an evolution takes the place of an earlier one, and no other files'", "[mesher][io][errors]") {
  const support::TemporaryFolder folder;
  const Mesh mesh = support::rectangle_mesh(2, 2);
  const auto write = [&](const std::string& name) { EvolutionWriter(folder / name).finish(mesh); };
  write("frames");
  folder.write("frames/frame_042.vtu", "of a longer evolution");
  folder.write("frames/notes.txt", "of the user");
  write("frames");
  CHECK_FALSE(std::filesystem::exists(folder / "frames/frame_042.vtu"));
  CHECK(support::content_of(folder / "frames/notes.txt") == "of the user");
  std::filesystem::create_directory(folder / "page");
  const std::string page = folder.write("page/index.html", "of the user");
  CHECK_THROWS_AS(write("page"), FileError);
  CHECK(support::content_of(page) == "of the user");
}
