package org.dfra.cli.module;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.PrintWriter;
import java.io.StringWriter;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.UUID;
import java.util.concurrent.Callable;
import org.dfra.directory.Locality;
import org.dfra.lifecycle.Readiness;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.river.lookup.JiniModuleDirectory.UnreadableModule;
import org.junit.jupiter.api.Test;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** A list of modules shows why one of them cannot be used. */
class ModuleListPrinterTest {

  private static final String WHY = "it awaits its first GpsFix";

  @Command(name = "list")
  private static final class Listing implements Callable<Integer> {

    @Mixin private CommandOutput output;

    private final List<ModuleView> modules;

    Listing(ModuleView... modules) {
      this.modules = List.of(modules);
    }

    @Override
    public Integer call() {
      ModuleListPrinter.show(output, modules, "No module is registered.");
      return 0;
    }
  }

  private static String print(Listing listing, String... options) {
    StringWriter out = new StringWriter();
    new CommandLine(listing).setOut(new PrintWriter(out)).execute(options);
    return out.toString();
  }

  private static ModuleView module(String name, Readiness state) {
    return new ModuleView(
        "atrv1",
        name,
        List.of("GPSSensor"),
        Optional.of(state),
        false,
        0,
        "127.0.0.1",
        Locality.REMOTE,
        false,
        Instant.EPOCH,
        UUID.randomUUID().toString(),
        Optional.empty(),
        false,
        Optional.empty());
  }

  @Test
  void saysWhyAModuleIsNotReadyBelowTheTable() {
    ModuleView waiting = module("gps", Readiness.INITIALIZING).withReason(WHY);
    String printed = print(new Listing(module("laser", Readiness.READY), waiting));
    assertThat(printed.lines().toList())
        .hasSize(4)
        .anyMatch(line -> line.contains("atrv1/laser") && line.contains("ready"))
        .anyMatch(line -> line.contains("atrv1/gps") && line.contains("initializing"))
        .last()
        .isEqualTo("atrv1/gps is initializing: it awaits its first GpsFix.");
  }

  @Test
  void givesTheReasonToPrograms() {
    ModuleView waiting = module("gps", Readiness.INITIALIZING).withReason(WHY);
    assertThat(print(new Listing(waiting), "--json"))
        .containsPattern("\"reason\"\\s*:\\s*\"" + WHY + "\"")
        .doesNotContain("is initializing:");
  }

  @Test
  void saysWhyAModuleIsRefusedHere() {
    ModuleView refused =
        ModuleView.of(
            new UnreadableModule(
                "atrv1", "odd", "10.0.0.7", "00000001", "its class is not known here"));
    assertThat(print(new Listing(refused)))
        .contains("refused")
        .endsWith("atrv1/odd cannot be used here: its class is not known here.\n");
  }

  @Test
  void saysNothingOfOneThatServes() {
    assertThat(print(new Listing(module("laser", Readiness.ACTIVE))).lines()).hasSize(2);
  }
}
