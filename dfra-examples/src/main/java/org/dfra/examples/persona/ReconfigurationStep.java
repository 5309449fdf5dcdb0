package org.dfra.examples.persona;

import java.time.Duration;
import java.util.Comparator;
import java.util.List;
import java.util.UUID;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.SourceLocation;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.examples.harness.DemoRobot;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.persona.ModuleAttributes;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;

/** A module is added to a working robot, replaced by a newer version, and removed. */
final class ReconfigurationStep {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;
  private static final Duration SOON = Duration.ofSeconds(5);
  private static final String NAME = "gps_roof";

  private final ProgressReporter progress;
  private final DemoRobot robot;
  private final ModuleDirectory directory;
  private final ModuleQuery<GPSSensor> query;

  ReconfigurationStep(ProgressReporter progress, DemoRobot robot, ModuleDirectory directory) {
    this.progress = progress;
    this.robot = robot;
    this.directory = directory;
    this.query = ModuleQuery.of(GPSSensor.class).robot(robot.name()).name(NAME);
  }

  /**
   * Changes the robot.
   *
   * @param link to the added receiver
   * @param model the module that it copies, and whose process it joins
   * @param logs subscriptions that should not be affected
   */
  void play(String link, String model, List<FixLog> logs) throws Exception {
    progress.section("adding a module", "The robot is reconfigured while it runs");
    List<FixLog.RecordingPeriod> stretches = logs.stream().map(FixLog::begin).toList();
    ModuleDescription first = like(model, link);
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    robot.bootstrap().add(first, model);
    ModuleListing<GPSSensor> added = await(first);
    Duration adding = watch.elapsed();
    progress.say(
        "A third receiver, module %s, was added to the process of %s/%s. After %s it was ready and"
            + " listed:",
        added.path(), robot.name(), model, QuantityText.seconds(adding));
    progress.show(PersonaSheet.modules(List.of(added)));
    progress.figure("module added to it working and shown", adding, SOON);
    await(stretches, 2);

    progress.step("replacing a module");
    UUID id = added.id();
    ModuleDescription newer = first.withDriver(AveragingM12Impl.class.getName());
    watch = progress.stopwatch();
    robot.bootstrap().replace(newer);
    ModuleListing<GPSSensor> replaced = await(newer);
    Duration replacing = watch.elapsed();
    DemoAssertions.require(replaced.id().equals(id), "the newer version has another service ID");
    progress.say(
        "It was replaced by a newer version of its driver, which averages positions. After %s this"
            + " was ready and listed, with the same service ID. The proxy that the client used for"
            + " the old version reaches the new one, and returns %s:",
        QuantityText.seconds(replacing), QuantityText.place(added.module().location().position()));
    progress.show(PersonaSheet.modules(List.of(replaced)));
    progress.figure("module replaced to the newer one working and shown", replacing, SOON);
    await(stretches, 4);

    progress.step("removing a module");
    watch = progress.stopwatch();
    robot.bootstrap().remove(NAME);
    DemoAssertions.await(
        "that the module is no longer listed", PATIENCE, () -> directory.find(query).isEmpty());
    Duration removing = watch.elapsed();
    progress.say(
        "It was removed, and disappeared from the robot's persona after %s.",
        QuantityText.seconds(removing));
    progress.figure("module removed to it gone", removing, SOON);
    await(stretches, 6);
    reportOthers(stretches);
  }

  /** Waits until every subscription has received this number of readings. */
  private static void await(List<FixLog.RecordingPeriod> stretches, int readings) throws Exception {
    for (FixLog.RecordingPeriod each : stretches) {
      each.await(readings, PATIENCE);
    }
  }

  /** Waits until the module with this driver is ready. */
  private ModuleListing<GPSSensor> await(ModuleDescription module) throws Exception {
    ModuleQuery<GPSSensor> exactly =
        query.where(ModuleAttributes.class, "driver", Condition.equalTo(module.driverClass()));
    DemoAssertions.await(
        "that " + module.path() + " is ready and listed",
        PATIENCE,
        () ->
            directory.find(exactly).stream()
                .flatMap(each -> each.attributes(ModuleAttributes.class).stream())
                .anyMatch(each -> each.state().serves()));
    return directory.findFirst(exactly, Duration.ZERO).orElseThrow();
  }

  private void reportOthers(List<FixLog.RecordingPeriod> stretches) {
    List<FixLog.Summary> all = stretches.stream().map(FixLog.RecordingPeriod::end).toList();
    long lost = all.stream().mapToLong(FixLog.Summary::lost).sum();
    long readings = all.stream().mapToLong(FixLog.Summary::readings).sum();
    Duration longest =
        all.stream()
            .map(FixLog.Summary::longestWait)
            .max(Comparator.naturalOrder())
            .orElse(Duration.ZERO);
    progress.say(
        "Meanwhile the client received the readings of the other %2$d receivers, one of them in the"
            + " same process: %1$d arrived, %3$d were lost, and the longest wait for the next was"
            + " %4$s.",
        readings, all.size(), lost, QuantityText.seconds(longest));
    progress.figure("readings lost while the robot was changed", lost, 0, "");
    progress.figure(
        "longest wait for a reading while the robot was changed", longest, Duration.ofSeconds(2));
  }

  private ModuleDescription like(String model, String link) {
    ModuleDescription known =
        robot.description().modules().stream()
            .filter(each -> each.name().equals(model))
            .findFirst()
            .orElseThrow();
    return known.withName(NAME).withParameter("link", link, SourceLocation.CODE);
  }
}
