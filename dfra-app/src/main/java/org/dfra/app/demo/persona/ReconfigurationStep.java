package org.dfra.app.demo.persona;

import java.time.Duration;
import java.util.Comparator;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.UUID;
import org.dfra.app.demo.harness.DemoAssertions;
import org.dfra.app.demo.harness.DemoRobot;
import org.dfra.app.demo.harness.ProgressReporter;
import org.dfra.app.demo.harness.QuantityText;
import org.dfra.core.config.ModuleDescription;
import org.dfra.core.config.Parameters;
import org.dfra.core.config.Place;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.flow.sensor.GPSSensor;
import org.dfra.persona.ModuleAttributes;

/** A module is added to a working robot, replaced by a newer version, and removed. */
final class ReconfigurationStep {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
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
    progress.chapter("adding a module", "The robot is changed while it works");
    List<FixLog.RecordingPeriod> stretches = logs.stream().map(FixLog::begin).toList();
    ModuleDescription first = like(model, link);
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    robot.bootstrap().add(first, model);
    ModuleListing<GPSSensor> added = await(first);
    Duration adding = watch.elapsed();
    progress.say(
        "A third receiver, module %s, was added to the process of %s/%s. After %s it worked and was"
            + " shown:",
        added.path(), robot.name(), model, QuantityText.seconds(adding));
    progress.show(PersonaSheet.modules(List.of(added)));
    progress.figure("module added to it working and shown", adding, SOON);
    await(stretches, 2);

    progress.step("replacing a module");
    UUID id = added.id();
    ModuleDescription newer = withDriver(first, AveragingM12Impl.class.getName());
    watch = progress.stopwatch();
    robot.bootstrap().replace(newer);
    ModuleListing<GPSSensor> replaced = await(newer);
    Duration replacing = watch.elapsed();
    DemoAssertions.require(replaced.id().equals(id), "the newer version has another identity");
    progress.say(
        "It was replaced by a newer version of its driver, which averages positions. After %s that"
            + " worked and was shown, under the same identity. The object through which the client"
            + " used the old one reaches the new one, and says %s:",
        QuantityText.seconds(replacing), QuantityText.place(added.module().location().position()));
    progress.show(PersonaSheet.modules(List.of(replaced)));
    progress.figure("module replaced to the newer one working and shown", replacing, SOON);
    await(stretches, 4);

    progress.step("removing a module");
    watch = progress.stopwatch();
    robot.bootstrap().remove(NAME);
    DemoAssertions.await(
        "that the module is gone", PATIENCE, () -> directory.find(query).isEmpty());
    Duration removing = watch.elapsed();
    progress.say(
        "It was removed, and gone from the robot's persona after %s.",
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
        "that " + module.path() + " works and is shown",
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
        "All the while the client got the readings of the other %2$d receivers, one of them in the"
            + " same process: %1$d came, %3$d were lost, and it never waited longer than %4$s for the"
            + " next.",
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
    Map<String, String> parameters = new HashMap<>();
    known.parameters().all().forEach((name, value) -> parameters.put(name, value.text()));
    parameters.put("link", link);
    return new ModuleDescription(
        known.robot(),
        NAME,
        known.serverClass(),
        known.proxyClass(),
        known.driverClass(),
        known.configuration(),
        known.restart(),
        Parameters.of(known.robot() + "/" + NAME, parameters),
        Place.CODE);
  }

  private static ModuleDescription withDriver(ModuleDescription module, String driver) {
    return new ModuleDescription(
        module.robot(),
        module.name(),
        module.serverClass(),
        module.proxyClass(),
        driver,
        module.configuration(),
        module.restart(),
        module.parameters(),
        module.place());
  }
}
