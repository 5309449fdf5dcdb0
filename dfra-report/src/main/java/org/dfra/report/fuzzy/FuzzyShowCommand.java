package org.dfra.report.fuzzy;

import java.io.IOException;
import java.nio.file.AccessDeniedException;
import java.nio.file.Files;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import org.dfra.behaviors.fuzzy.FuzzySystem;
import org.dfra.core.host.CommandName;
import org.dfra.report.plot.Page;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code ./dfra fuzzy show}. */
@Command(
    name = "show",
    description = "Lists the inputs and outputs of a fuzzy system, and draws it.",
    footer = {
      "",
      "The image shows the membership functions of each input and output, each output over",
      "two inputs, and the rules. An input that is not along an axis is held at the middle of",
      "its range, or at the value of --at.",
      "",
      "For example:",
      "  "
          + CommandName.IN_HELP
          + " fuzzy show config/fuzzy/waypoint.fis --surface centre,heading_error"
    })
final class FuzzyShowCommand implements Callable<Integer> {

  @Parameters(paramLabel = "FILE.FIS", description = "The system, in MATLAB's file format.")
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private Path file;

  @Option(
      names = "--output",
      paramLabel = "FILE.SVG",
      description = "Image file (default: the system's file name with .svg, in this folder).")
  private @Nullable Path output;

  @Option(
      names = "--surface",
      paramLabel = "IN1,IN2[,OUT]",
      description =
          "Draw the outputs, or only OUT, over inputs IN1 and IN2; may be repeated (default: the"
              + " outputs over the first two inputs).")
  private List<String> surfaces = new ArrayList<>();

  @Option(
      names = "--at",
      paramLabel = "NAME=VALUE",
      description = "Hold input NAME at VALUE; may be repeated.")
  private List<String> held = new ArrayList<>();

  @Mixin
  @SuppressWarnings("NullAway.Init") // set by picocli before the call
  private CommandOutput answer;

  @Override
  public Integer call() {
    Page.setHeadless();
    FuzzySystem system = FuzzySystem.read(file);
    List<Surface> asked = new SurfaceOptions(system).surfaces(surfaces, held);
    Path picture = output == null ? beside(file) : output;
    write(new SystemPage(system, asked).page(), picture);
    SystemView view = SystemView.of(system, asked, picture);
    answer.lines(view, view.lines());
    return ExitCode.SUCCESS;
  }

  private static Path beside(Path file) {
    String name = String.valueOf(file.getFileName()).replaceFirst("\\.fis$", "");
    return Path.of(name + ".svg");
  }

  private void write(Page page, Path picture) {
    try {
      if (Files.exists(picture) && Files.isSameFile(picture, file)) {
        throw unwritable(picture, "it is the system itself");
      }
      page.write(picture);
    } catch (NoSuchFileException e) {
      throw unwritable(picture, whyNot(picture.toAbsolutePath().getParent()));
    } catch (AccessDeniedException e) {
      throw unwritable(picture, "that is not permitted");
    } catch (IOException e) {
      String why = Files.isDirectory(picture) ? "it is a folder" : String.valueOf(e.getMessage());
      throw unwritable(picture, why);
    }
  }

  private static String whyNot(@Nullable Path folder) {
    return folder != null && Files.isDirectory(folder)
        ? folder + " takes no such file"
        : "there is no folder " + folder;
  }

  private static CommandFailure unwritable(Path picture, String why) {
    return new CommandFailure(
        ExitCode.FAILED,
        picture + " cannot be written: " + why + "; name another file with --output");
  }
}
