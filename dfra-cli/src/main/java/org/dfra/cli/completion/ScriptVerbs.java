package org.dfra.cli.completion;

import java.util.List;
import java.util.stream.Stream;
import org.dfra.core.host.CommandName;
import picocli.CommandLine;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Model.OptionSpec;

/**
 * The subcommands that the script {@code ./dfra} of a checkout implements itself: they compile, or
 * run compiled classes. An installation has none of them.
 */
public final class ScriptVerbs {

  private ScriptVerbs() {}

  /** The subcommands' names; empty in an installation. */
  public static List<String> names() {
    return CommandName.isInstalled() ? List.of() : List.of("build", "dist", "javadoc", "test");
  }

  /** The help text about them. */
  public static String[] help() {
    return names().isEmpty()
        ? new String[0]
        : new String[] {
          "",
          "Also, by the script itself:",
          "  build    Builds new jars from the sources; running processes keep theirs.",
          "  dist     Packs DFRA for a computer that has only a Java runtime;",
          "           --flight: also drivers of flight controllers, for robots that fly;",
          "           --complete: also these, demonstrations, simulation and benchmarks.",
          "  javadoc  Builds the API documentation; fails if Javadoc has a warning.",
          "  test     Runs tests:",
          "           test [--full|--soak] [--integration] [--java HOME] [--seed N].",
        };
  }

  /** Adds them to a command line that is inspected, not run. */
  public static void addTo(CommandLine line) {
    for (String name : names()) {
      CommandSpec spec = CommandSpec.create();
      if (name.equals("test")) {
        Stream.of("--full", "--soak", "--integration")
            .forEach(option -> spec.addOption(option(option)));
        spec.addOption(
            OptionSpec.builder("--java").paramLabel("HOME").type(java.io.File.class).build());
        spec.addOption(OptionSpec.builder("--seed").paramLabel("N").type(String.class).build());
      }
      if (name.equals("dist")) {
        Stream.of("--flight", "--complete").forEach(option -> spec.addOption(option(option)));
      }
      spec.addOption(option("--help"));
      line.addSubcommand(name, spec);
    }
  }

  private static OptionSpec option(String name) {
    return OptionSpec.builder(name).type(boolean.class).build();
  }
}
