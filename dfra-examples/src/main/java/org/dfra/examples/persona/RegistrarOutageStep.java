package org.dfra.examples.persona;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.util.List;
import java.util.Set;
import java.util.UUID;
import java.util.stream.Collectors;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.Persona;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;

/** A robot's registrar dies, and no process restarts it: the robot is listed as stale. */
final class RegistrarOutageStep {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;

  private final ProgressReporter progress;
  private final DemoEnvironment environment;
  private final DemoRobot robot;
  private final ModuleDirectory directory;

  RegistrarOutageStep(
      ProgressReporter progress,
      DemoEnvironment environment,
      DemoRobot robot,
      ModuleDirectory directory) {
    this.progress = progress;
    this.environment = environment;
    this.robot = robot;
    this.directory = directory;
  }

  /**
   * Kills the registrar and the phoenix that would restart it, and starts phoenix again.
   *
   * @param log the subscription to a receiver of the robot
   */
  void play(FixLog log) throws Exception {
    progress.section("killing the registrar", "A robot's registrar fails for a while");
    Set<UUID> before = ids();
    long registrar = robot.process("lookup");
    robot.host().killPhoenix();
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    environment.signal("KILL", registrar);
    DemoAssertions.await("that the persona is stale", PATIENCE, () -> persona().stale());
    Duration stale = watch.elapsed();
    progress.say(
        "The registrar of %s, process %d, and its phoenix, which would restart it, were both killed."
            + " After %s the client shows the robot as stale, with its age, and keeps its cached"
            + " data:",
        robot.name(), registrar, QuantityText.seconds(stale));
    show();
    progress.figure("registrar dead to its robot shown as stale", stale, Duration.ofSeconds(5));

    FixLog.RecordingPeriod meanwhile = log.begin();
    watch = progress.stopwatch();
    String frame = log.gps().location().frame();
    Duration call = watch.elapsed();
    meanwhile.await(2, PATIENCE);
    FixLog.Summary summary = meanwhile.end();
    progress.say(
        "Stale does not mean dead: %s answered a call after %s, and %d more readings arrived meanwhile.",
        frame, QuantityText.seconds(call), summary.readings());
    show();
    DemoAssertions.require(
        summary.lost() == 0, summary.lost() + " readings of " + frame + " were lost");

    progress.step("bringing the registrar back");
    watch = progress.stopwatch();
    ProcessHandle phoenix = robot.host().startPhoenix();
    DemoAssertions.await("that the persona is fresh again", PATIENCE, () -> !persona().stale());
    DemoAssertions.await(
        "that every module is fresh again",
        PATIENCE,
        () -> persona().modules().stream().noneMatch(ModuleListing::stale));
    Duration fresh = watch.elapsed();
    progress.say(
        "Phoenix was started again, process %d: it adopted the running processes and restarted the"
            + " registrar, process %d. The robot was fresh again after %s, with the same modules and"
            + " the same service IDs.",
        phoenix.pid(), robot.process("lookup"), QuantityText.seconds(fresh));
    show();
    DemoAssertions.require(ids().equals(before), "the modules have other service IDs than before");
    progress.figure("phoenix started again to the robot fresh", fresh, Duration.ofSeconds(10));
  }

  private void show() throws IOException {
    progress.show(List.of("  " + PersonaSheet.headline(persona(), Instant.now())));
  }

  private Persona persona() throws IOException {
    return directory.personas().stream()
        .filter(each -> each.robot().equals(robot.name()))
        .findFirst()
        .orElseThrow(() -> new IOException("the directory no longer has " + robot.name()));
  }

  private Set<UUID> ids() throws IOException {
    return persona().modules().stream().map(ModuleListing::id).collect(Collectors.toSet());
  }
}
