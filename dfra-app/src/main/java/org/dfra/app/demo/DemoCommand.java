package org.dfra.app.demo;

import java.io.PrintWriter;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.dfra.app.figure.RecordOption;
import org.dfra.app.terminal.ExitCode;
import org.jspecify.annotations.Nullable;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Parameters;
import picocli.CommandLine.Spec;

/** {@code ./dfra demo}: runs a demonstration, the newest one where none is named. */
@Command(
    name = "demo",
    description = "Runs a demonstration with real processes on this machine.",
    footer = {
      "",
      "Ends with 1 where a step fails, or a measured figure is not as wanted.",
      "",
      "Demonstrations, the newest first:",
      "  persona      two robots: modules found by what they can do, kept through failures",
      "  foundation   a GPS receiver found by what it can do, and back after kill -9"
    })
public final class DemoCommand implements Callable<Integer> {

  /** By name, the newest first. */
  private static final Map<String, Function<Narration, Demo>> DEMOS = new LinkedHashMap<>();

  static {
    DEMOS.put("persona", PersonaDemo::new);
    DEMOS.put("foundation", FoundationDemo::new);
  }

  @Parameters(
      arity = "0..1",
      paramLabel = "NAME",
      description = "Which one; without it, the newest.")
  private @Nullable String name;

  @Mixin
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private RecordOption record;

  @Spec
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private CommandSpec spec;

  @Override
  public Integer call() throws Exception {
    PrintWriter out = spec.commandLine().getOut();
    String chosen = name == null ? DEMOS.keySet().iterator().next() : name;
    Function<Narration, Demo> demo = DEMOS.get(chosen);
    if (demo == null) {
      throw new ParameterException(
          spec.commandLine(),
          "there is no demonstration \""
              + chosen
              + "\"; there is "
              + String.join(", ", DEMOS.keySet()));
    }
    Narration narration = new Narration(out, System::nanoTime);
    if (!demo.apply(narration).run()) {
      return ExitCode.FAILED;
    }
    record.keep(narration.figures(), "demo", chosen);
    return narration.figures().missed().isEmpty() ? ExitCode.WELL : ExitCode.FAILED;
  }
}
