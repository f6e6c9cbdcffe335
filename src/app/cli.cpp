// SPDX-License-Identifier: MIT
// The options of every command, and what is said about a wrong command line.
#include "app/cli.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <filesystem>
#include <new>
#include <optional>
#include <string>
#include <tuple>
#include <vector>

#include "app/commands.hpp"
#include "app/frame_range.hpp"
#include "app/messages.hpp"
#include "app/open_editor.hpp"
#include "app/output.hpp"
#include "app/picture_size.hpp"
#include "app/suggestion.hpp"

namespace vides {
namespace {

// "vides, csv, json, chan", and what each is, a line each.
std::vector<std::string> formatNames() {
  std::vector<std::string> names;
  for (const FrameFormat* format : frameFormats()) names.emplace_back(format->name);
  return names;
}
std::string formatList() {
  std::string list = "\nFormats:\n";
  for (const FrameFormat* format : frameFormats()) {
    list += fmt::format("  {:7} {}{}\n", format->name, format->purpose,
                        format == frameFormats().front() ? " (default)" : "");
  }
  return list;
}
// Of those formats of which `has` is so: "chan", "chan, other".
std::string formatsThat(bool (*has)(const FrameFormat&)) {
  std::string list;
  for (const FrameFormat* format : frameFormats()) {
    if (has(*format)) list += (list.empty() ? "" : ", ") + std::string(format->name);
  }
  return list;
}
std::string numberedFormats() {
  return formatsThat([](const FrameFormat& format) { return format.numbered; });
}
std::string worldFormats() {
  return formatsThat([](const FrameFormat& format) { return format.space == FrameSpace::kWorld; });
}

constexpr const char* kFramesFooter = R"(
Frames are counted from 0. --range clips to the flight; a part of the frames has
the lines that it has in the whole, whatever the format: in chan the angles
continue without a jump from the flight's first frame, and over the poles, where
rx goes on beyond 90 degrees.

Examples:
  vides frames flight.vid
  vides frames flight.vid --format csv --space world -o flight.csv
  vides frames flight.vid --format chan --range 100:200 -o part.chan
  generate | vides frames - | render)";

constexpr const char* kDriveFooter = R"(
A script has a line per command; # begins a comment. Pixels count from the upper
left corner.
  frame [N]   move X Y   press BUTTON   release BUTTON   wheel DY
  drag BUTTON X1 Y1 X2 Y2 [STEPS]   key NAME   down NAME   up NAME   text "..."
  click ID   set ID VALUE   do COMMAND [ARGS]   drop FILE
  where key I | where aim I J | where up I J | where curve I U
  where widget ID [U V]
  point $NAME where ...   view VIEW   view TURN TILT SIZE   perspective on|off
  frame_at N   print POINTER   expect POINTER VALUE [TOL]
  expect_output "TEXT"   expect_title "TEXT"   expect_widget ID "VALUE"
  expect_setup POINTER VALUE [TOL]
  save FILE   open FILE   undo   redo   screenshot FILE
The first line that fails ends the run with status 1 and SCRIPT:LINE: what was
expected and found.)";

constexpr const char* kMainFooter = R"(
FLIGHT may be - for standard input. Exit status: 0 done, 1 the work failed or the
input is bad, 2 the command line is wrong. NO_COLOR is honoured.
`vides COMMAND --help` tells more about a command.)";

// The command line's words, and where what they say is put.
class Parser {
 public:
  Parser() : app_("Camera flights through a 3-D scene.", "vides") {
    app_.set_version_flag("--version", "vides " VIDES_VERSION, "Print the version and exit");
    app_.set_help_flag("-h,--help", "Print this help and exit");
    app_.add_option("FLIGHT", operand, "A flight to open in the editor")->type_name("FILE");
    app_.require_subcommand(0, 1);
    app_.footer(kMainFooter);
    addFrames();
    addInfo();
    addCheck();
    addScreenshot();
    addDrive();
  }

  CLI::App& app() { return app_; }
  const CLI::App* command() const {
    const auto commands = app_.get_subcommands();
    return commands.empty() ? nullptr : commands.front();
  }
  // All commands, or all options of one, and the ways to ask.
  std::vector<std::string> commandNames() const {
    std::vector<std::string> names;
    for (const CLI::App* c : app_.get_subcommands([](const CLI::App*) { return true; })) {
      names.push_back(c->get_name());
    }
    names.insert(names.end(), {"--help", "--version"});
    return names;
  }
  static std::vector<std::string> optionNames(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options()) {
      for (const std::string& name : option->get_lnames()) names.push_back("--" + name);
    }
    return names;
  }

  int run() const {
    const CLI::App* const chosen = command();
    if (chosen == frames_) return runFrames(frames);
    if (chosen == info_) return runInfo(info);
    if (chosen == check_) return runCheck(check);
    if (chosen == screenshot_) return runScreenshot(screenshot);
    if (chosen == drive_) return runDrive(drive);
    return openEditor(operand);
  }

  // What no single option can know.
  void checkTogether() const {
    if (firstNumberGiven_ && !frames.options.format->numbered) {
      throw CLI::ValidationError(
          "--first-frame",
          fmt::format("only frames of --format {} have numbers", numberedFormats()));
    }
    if (command() == drive_ && drive.script.empty() && !drive.listWidgets) {
      throw CLI::ValidationError("--script", "a script is needed (or --list-widgets)");
    }
  }

  std::optional<std::string> operand;  // without a command
  FramesCommand frames;
  InfoCommand info;
  CheckCommand check;
  ScreenshotCommand screenshot;
  DriveCommand drive;

 private:
  CLI::App* addCommand(const char* name, const char* purpose) {
    CLI::App* const command = app_.add_subcommand(name, purpose);
    command->set_version_flag("--version", "vides " VIDES_VERSION, "Print the version and exit");
    command->set_help_flag("-h,--help", "Print this help and exit");
    return command;
  }

  void addFrames() {
    frames_ = addCommand("frames", "Write the frames: a camera per frame");
    frames_->add_option("FLIGHT", frames.flight, "The flight; - for standard input")
        ->type_name("FILE")
        ->required();
    frames_
        ->add_option("-o,--output", frames.output,
                     "Where to write, whole or not at all; - (default) for standard output")
        ->type_name("OUT");
    frames_
        ->add_option_function<std::string>(
            "--format", [this](const std::string& text) { setFormat(text); },
            fmt::format("{} (default: {})", fmt::join(formatNames(), ", "),
                        frameFormats().front()->name))
        ->type_name("F");
    frames_
        ->add_option_function<std::string>(
            "--space", [this](const std::string& text) { setSpace(text); },
            "Positions in the cube or in the scene's world (default: cube; world for " +
                worldFormats() + ")")
        ->type_name("cube|world");
    frames_
        ->add_option_function<std::string>(
            "--range", [this](const std::string& text) { setRange(text); },
            "Only frames A <= n < B; either may be left out")
        ->type_name("A:B");
    frames_
        ->add_option_function<std::string>(
            "--first-frame", [this](const std::string& text) { setFirstNumber(text); },
            numberedFormats() + ": the number of the flight's first frame (default 1)")
        ->type_name("N");
    frames_->footer(formatList() + kFramesFooter);
  }

  void addInfo() {
    info_ = addCommand("info", "Tell what a flight consists of, and how well it flies");
    info_->add_option("FLIGHT", info.flight, "The flight; - for standard input")
        ->type_name("FILE")
        ->required();
    info_->add_flag("--json", info.json, "For programs: one JSON object");
    info_->footer(
        "\nKeys and orientations are counted from 0: 4.1 is the second orientation of the\n"
        "fifth key.");
  }

  void addCheck() {
    check_ = addCommand("check", "Tell everything that is wrong with flights");
    check_->add_option("FLIGHT", check.flights, "Flights; - for standard input")
        ->type_name("FILE")
        ->required();
    check_->footer(
        "\nPrints a line per problem, FILE: POINTER: MESSAGE, to standard output, and ends with\n"
        "status 1 if there is one. Says nothing of flights that are right.");
  }

  void addScreenshot() {
    screenshot_ = addCommand("screenshot", "Write a picture of the viewport or the window");
    screenshot_->add_option("FLIGHT", screenshot.flight, "The flight; - for standard input")
        ->type_name("FILE")
        ->required();
    screenshot_->add_option("-o,--output", screenshot.output, "The picture to write")
        ->type_name("PNG")
        ->required();
    addPictureOptions(*screenshot_, screenshot.width, screenshot.height, screenshot.scale,
                      screenshot.offscreen);
    screenshot_->add_option("--view", screenshot.view, "iso (default), front, side, top or camera")
        ->type_name("VIEW")
        ->check(CLI::IsMember({"iso", "front", "side", "top", "camera"}));
    screenshot_
        ->add_option_function<std::string>(
            "--frame",
            [this](const std::string& text) {
              const auto number = parseFrameNumber(text);
              if (!number || *number < 0) {
                throw CLI::ValidationError("--frame",
                                           fmt::format("'{}' is not a frame's number", text));
              }
              screenshot.frame = *number;
            },
            "The frame that the playhead stands on (default 0)")
        ->type_name("N");
    screenshot_->add_flag("--whole-window", screenshot.wholeWindow,
                          "The whole editor with its panels");
  }

  void addDrive() {
    drive_ = addCommand("drive", "Run the editor without a display, moved by a script");
    drive_->add_option("FLIGHT", drive.flight, "The flight to begin with (default: a new one)")
        ->type_name("FILE");
    drive_->add_option("--script", drive.script, "What to do; - for standard input")
        ->type_name("FILE");
    addPictureOptions(*drive_, drive.width, drive.height, drive.scale, drive.offscreen);
    drive_->add_option("--language", drive.language, "en or de (default: the setup's, else en)")
        ->type_name("en|de")
        ->check(CLI::IsMember({"en", "de"}));
    drive_->add_option("--setup", drive.setup, "A setup file (default: the built-in setup)")
        ->type_name("FILE");
    drive_->add_flag("--list-widgets", drive.listWidgets,
                     "Print every widget's identifier and label instead");
    drive_
        ->add_option("--operated", drive.operated,
                     "Write which commands, shortcuts and widgets the script operated")
        ->type_name("FILE");
    drive_->footer(kDriveFooter);
  }

  static void addPictureOptions(CLI::App& command, int& width, int& height, double& scale,
                                std::string& offscreen) {
    command
        .add_option_function<std::string>(
            "--size",
            [&width, &height](const std::string& text) {
              if (const auto size = parsePictureSize(text)) {
                std::tie(width, height) = *size;
              } else {
                throw CLI::ValidationError(
                    "--size", fmt::format("'{}' is not WIDTHxHEIGHT in pixels, 1 to 16384", text));
              }
            },
            "Size in pixels (default 1280x800)")
        ->type_name("WxH");
    command.add_option("--scale", scale, "How large widgets and texts are, 0.75 to 3 (default 1)")
        ->type_name("S")
        ->check(CLI::Range(0.75, 3.0));
    command.add_option("--offscreen", offscreen, "What draws: osmesa (default) or egl")
        ->type_name("osmesa|egl")
        ->check(CLI::IsMember({"osmesa", "egl"}));
  }

  void setFormat(const std::string& text) {
    if (const FrameFormat* const format = frameFormat(text)) {
      frames.options.format = format;
      return;
    }
    const std::vector<std::string> names = formatNames();
    const std::string near = nearestWord(text, names);
    throw CLI::ValidationError(
        "--format", fmt::format("unknown format '{}': {}", text,
                                near.empty() ? fmt::format("there are {}", fmt::join(names, ", "))
                                             : fmt::format("did you mean '{}'?", near)));
  }

  void setSpace(const std::string& text) {
    if (text == "cube") {
      frames.options.space = FrameSpace::kCube;
    } else if (text == "world") {
      frames.options.space = FrameSpace::kWorld;
    } else {
      throw CLI::ValidationError("--space", fmt::format("'{}' is neither cube nor world", text));
    }
  }

  void setRange(const std::string& text) {
    const auto range = parseFrameRange(text);
    if (!range) throw CLI::ValidationError("--range", range.error());
    frames.options.first = range->first;
    frames.options.last = range->last;
  }

  void setFirstNumber(const std::string& text) {
    const auto number = parseFrameNumber(text);
    if (!number) {
      throw CLI::ValidationError(
          "--first-frame", fmt::format("'{}' is not a whole number of at most 12 digits", text));
    }
    frames.options.firstNumber = *number;
    firstNumberGiven_ = true;
  }

  CLI::App app_;
  CLI::App* frames_ = nullptr;
  CLI::App* info_ = nullptr;
  CLI::App* check_ = nullptr;
  CLI::App* screenshot_ = nullptr;
  CLI::App* drive_ = nullptr;
  bool firstNumberGiven_ = false;
};

int wrong(const Parser& parser, const std::string& message) {
  const CLI::App* const command = parser.command();
  const std::string name = command == nullptr ? "" : command->get_name() + " ";
  tell(message);
  tell(fmt::format("see vides {}--help", name));
  return kWrongCommandLine;
}

std::string didYouMean(std::string_view word, const std::vector<std::string>& known) {
  const std::string near = nearestWord(word, known);
  return near.empty() ? "" : fmt::format("; did you mean '{}'?", near);
}

// Whether the operand of `vides OPERAND` can't be a flight, and so is a command misspelt.
bool looksLikeCommand(const std::string& operand) {
  std::error_code ignored;
  return operand.find_first_of("./-") != 0 && operand.find_first_of("./") == std::string::npos &&
         !std::filesystem::exists(operand, ignored);
}

// Says what is wrong with the operand that belongs to no command; 0 if nothing.
int checkOperand(const Parser& parser) {
  if (!parser.operand) return 0;
  const std::string& operand = *parser.operand;
  if (parser.command() != nullptr) {
    return wrong(parser, fmt::format("'{}' stands before the command", operand));
  }
  if (looksLikeCommand(operand)) {
    return wrong(parser, fmt::format("'{}' is neither a command nor a file{}", operand,
                                     didYouMean(operand, parser.commandNames())));
  }
  return 0;
}

// An option or an operand that nobody knows.
int unexpected(Parser& parser) {
  if (const int status = checkOperand(parser); status != 0) return status;
  const std::vector<std::string> rest = parser.app().remaining(true);
  const std::string word = rest.empty() ? "" : rest.front();
  if (!word.starts_with("-")) {
    return wrong(parser, fmt::format("'{}' is one operand too many", word));
  }
  const CLI::App* const command = parser.command();
  const std::string name = word.substr(0, word.find('='));
  return wrong(parser,
               fmt::format("unknown option '{}'{}", name,
                           didYouMean(name, Parser::optionNames(command == nullptr ? parser.app()
                                                                                   : *command))));
}

int print(const std::string& text) {
  Output output;
  output.write(text);
  return output.finish() ? kExitDone : kFailed;
}

int parseAndRun(int argc, const char* const* argv) {
  Parser parser;
  try {
    parser.app().parse(argc, argv);
    parser.checkTogether();
  } catch (const CLI::CallForHelp&) {
    return print(parser.app().help());
  } catch (const CLI::CallForVersion& version) {
    return print(std::string(version.what()) + "\n");
  } catch (const CLI::ExtrasError&) {
    return unexpected(parser);
  } catch (const CLI::ParseError& error) {
    return wrong(parser, error.what());
  }
  if (const int status = checkOperand(parser); status != 0) return status;
  return parser.run();
}

}  // namespace

int runCommandLine(int argc, const char* const* argv) {
  try {
    return parseAndRun(argc, argv);
  } catch (const std::bad_alloc&) {
    tell("out of memory");
  } catch (const std::exception& error) {
    tell(error.what());
  }
  return kFailed;
}

}  // namespace vides
