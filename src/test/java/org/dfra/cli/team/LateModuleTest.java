package org.dfra.cli.team;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.awaitility.Awaitility.await;

import java.nio.file.Path;
import java.time.Duration;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import org.dfra.app.InProcessCommand;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.example.thermometer.SteadyThermometerImpl;
import org.dfra.example.thermometer.Thermometer;
import org.dfra.example.thermometer.ThermometerProxy;
import org.dfra.example.thermometer.ThermometerServer;
import org.dfra.module.Module;
import org.dfra.report.terminal.CommandFailure;
import org.dfra.report.terminal.CommandOutput;
import org.dfra.report.terminal.ExitCode;
import org.dfra.testing.EmbeddedReggie;
import org.dfra.testing.ServedModule;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;
import org.junit.jupiter.api.extension.RegisterExtension;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * A robot that is starting has a lookup service before it has its modules. A command waits for the
 * module until its own waiting time is over, and refuses only then.
 */
@Timeout(180)
class LateModuleTest {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  @RegisterExtension static final EmbeddedReggie REGGIE = new EmbeddedReggie();

  /** What a command knows that waits this long. */
  private static TeamDirectory team(Duration wait) throws Exception {
    return new TeamDirectory(REGGIE.directory(), wait, new CommandOutput(), REGGIE.locator());
  }

  private static ThermometerServer serve() throws Exception {
    return ServedModule.of(
            ThermometerServer.class, ThermometerProxy.class, SteadyThermometerImpl.class)
        .named("late")
        .joining(REGGIE)
        .serve();
  }

  /** Waits until the lookup service was read, and holds no other test's module any more. */
  private static void awaitNone(TeamDirectory team) {
    await()
        .atMost(PATIENCE)
        .until(() -> team.awaitDirectory().find(ModuleQuery.of(Module.class)).isEmpty());
  }

  /** Asks before the module is there, and has it join once the question waits. */
  private static <T> T askedBeforeItIsThere(Callable<T> question) throws Exception {
    FutureTask<T> asked = new FutureTask<>(question);
    Thread asking = new Thread(asked, "late-module-asking");
    asking.setDaemon(true);
    asking.start();
    await()
        .atMost(PATIENCE)
        .until(() -> asked.isDone() || asking.getState() == Thread.State.TIMED_WAITING);
    assertThat(asked.isDone()).as("refused before its time was over").isFalse();
    try (ThermometerServer served = serve()) {
      assertThat(served).isNotNull();
      return asked.get(PATIENCE.toSeconds(), TimeUnit.SECONDS);
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"late", "robot/late", "robot@127.0.0.1/late"})
  void aModuleThatJoinsWhileTheCommandWaitsIsFound(String name) throws Exception {
    try (TeamDirectory team = team(PATIENCE)) {
      awaitNone(team);
      ModuleListing<Module> found = askedBeforeItIsThere(() -> team.module(name));
      assertThat(found.path()).isEqualTo("robot/late");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"", "robot", "robot@127.0.0.1"})
  void soIsTheOneModuleOfAKindThatARobotHas(String robot) throws Exception {
    try (TeamDirectory team = team(PATIENCE)) {
      awaitNone(team);
      List<ModuleListing<Thermometer>> found =
          askedBeforeItIsThere(
              () ->
                  RobotModules.of(
                      team,
                      ModuleQuery.of(Thermometer.class),
                      robot.isEmpty() ? List.of() : List.of(robot),
                      "thermometer",
                      "bring one up"));
      assertThat(found).extracting(ModuleListing::path).containsExactly("robot/late");
    }
  }

  @Test
  void oneThatNeverComesIsRefusedWhenTheTimeIsOver() throws Exception {
    Duration wait = Duration.ofMillis(300);
    for (String name : List.of("never", "robot/never")) {
      long begun = System.nanoTime();
      try (TeamDirectory team = team(wait)) {
        assertThatThrownBy(() -> team.module(name))
            .isInstanceOf(CommandFailure.class)
            .hasMessage("there is no module " + name + "; ./dfra module list shows what there is");
        assertThat(Duration.ofNanos(System.nanoTime() - begun)).isGreaterThanOrEqualTo(wait);
      }
    }
    try (TeamDirectory team = team(wait)) {
      assertThatThrownBy(
              () ->
                  RobotModules.of(
                      team,
                      ModuleQuery.of(Thermometer.class),
                      List.of("robot"),
                      "thermometer",
                      "bring one up"))
          .isInstanceOf(CommandFailure.class)
          .hasMessage(
              "robot robot has no thermometer, or is not there; ./dfra persona list shows the"
                  + " robots");
    }
  }

  @Test
  void theCommandWaitsAsLongAsItsOptionSays(@TempDir Path folder) {
    long begun = System.nanoTime();
    InProcessCommand output =
        InProcessCommand.at(
            REGGIE, folder.resolve("state"), List.of("module", "get", "never", "--wait=1.5"));
    assertThat(output.code()).as(output.err()).isEqualTo(ExitCode.NOT_FOUND);
    assertThat(output.err())
        .isEqualTo(
            "dfra: there is no module never; ./dfra module list shows what there is"
                + System.lineSeparator());
    assertThat(Duration.ofNanos(System.nanoTime() - begun)).isGreaterThan(Duration.ofMillis(1500));
  }
}
