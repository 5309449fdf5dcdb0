package org.dfra.app;

import java.util.List;
import java.util.stream.Stream;
import org.dfra.app.terminal.CommandName;
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
  static List<String> names() {
    return CommandName.isInstalled() ? List.of() : List.of("build", "dist", "test");
  }

  /** The help text about them. */
  static String[] help() {
    return names().isEmpty()
        ? new String[0]
        : new String[] {
          "",
          "Also, by the script itself:",
          "  build  Makes new jars of the sources; what runs keeps its own.",
          "  dist   Packs what runs on a computer with only a Java runtime.",
          "  test   Runs tests:",
          "         test [--full|--soak] [--integration] [--java HOME] [--seed N].",
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
      spec.addOption(option("--help"));
      line.addSubcommand(name, spec);
    }
  }

  private static OptionSpec option(String name) {
    return OptionSpec.builder(name).type(boolean.class).build();
  }
}
