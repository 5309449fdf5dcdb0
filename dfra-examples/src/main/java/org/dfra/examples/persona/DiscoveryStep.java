package org.dfra.examples.persona;

import java.time.Duration;
import java.time.Instant;
import java.util.List;
import org.dfra.directory.Condition;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.directory.Persona;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.flow.sensor.LocationReading;
import org.dfra.flow.sensor.LocationSensor;
import org.dfra.module.Module;
import org.dfra.persona.GpsReceiverAttributes;
import org.dfra.persona.ModuleAttributes;
import org.dfra.persona.SensorAttributes;
import org.dfra.report.progress.DemoAssertions;
import org.dfra.report.progress.ProgressReporter;
import org.dfra.report.progress.QuantityText;
import org.dfra.report.terminal.Table;

/** A client discovers robots: their attributes, and queries over them. */
final class DiscoveryStep {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;

  /** The query of this demonstration, without a robot's name or a receiver's make. */
  static final ModuleQuery<LocationSensor> CAPABLE_SENSORS =
      ModuleQuery.of(LocationSensor.class)
          .where(SensorAttributes.class, "maxRate", Condition.atLeast(1))
          .where(GpsReceiverAttributes.class, "fixModes", Condition.contains("3D"));

  private final ProgressReporter progress;
  private final ModuleDirectory directory;

  DiscoveryStep(ProgressReporter progress, ModuleDirectory directory) {
    this.progress = progress;
    this.directory = directory;
  }

  /**
   * Waits for the robots and prints their attributes.
   *
   * @param robots number of robots
   * @param modules number of modules of each
   */
  void awaitRobots(int robots, int modules, ProgressReporter.Stopwatch sinceColdStart)
      throws Exception {
    progress.section("finding the robots", "A client finds the robots");
    DemoAssertions.await(
        "that " + robots + " robots show " + modules + " working modules each",
        PATIENCE,
        () ->
            directory.personas().size() == robots
                && directory.personas().stream().allMatch(each -> isComplete(each, modules)));
    Duration cold = sinceColdStart.elapsed();
    progress.say(
        "A client found both through their registrars, without knowing their names. What a robot"
            + " publishes about itself is its persona. The client reads it from the registrar and"
            + " calls no module. It is fresh as long as a registrar that answers lists it.");
    Instant now = Instant.now();
    progress.blank();
    directory
        .personas()
        .forEach(each -> progress.show(PersonaSheet.of(each, now, progress.columns())));
    progress.figure(
        "cold start of both robots to all modules working and shown", cold, Duration.ofSeconds(16));
  }

  private static boolean isComplete(Persona persona, int modules) {
    return persona.attributes().isPresent()
        && persona.modules().size() == modules
        && persona.modules().stream().allMatch(DiscoveryStep::works);
  }

  private static boolean works(ModuleListing<Module> listing) {
    return listing
        .attributes(ModuleAttributes.class)
        .filter(module -> module.state().serves())
        .isPresent();
  }

  /** Queries by capability. */
  void ask() throws Exception {
    progress.section("asking by capability", "The client queries by capability, not by name");
    List<ModuleListing<LocationSensor>> found = directory.find(CAPABLE_SENSORS);
    int rounds = 1000;
    ProgressReporter.Stopwatch watch = progress.stopwatch();
    for (int i = 0; i < rounds; i++) {
      found = directory.find(CAPABLE_SENSORS);
    }
    double micros = watch.elapsed().toNanos() / 1e3 / rounds;
    progress.say(
        "\"Location sensors on any robot, with a 3-D fix, at 1 Hz or more\": %d answers in %.1f µs,"
            + " from the client's cache. Each can be called immediately:",
        found.size(), micros);
    Table table = new Table("ANSWER", "POSITION", "CALL TOOK");
    for (ModuleListing<LocationSensor> each : found) {
      watch = progress.stopwatch();
      LocationReading location = each.module().location();
      String took = QuantityText.seconds(watch.elapsed());
      table.row(each.path(), QuantityText.place(location.position()), took);
    }
    progress.show(table);
    DemoAssertions.require(found.size() == 4, found.size() + " location sensors were found, not 4");
    progress.figure(
        "a question by capability, answered from the client's cache", micros / 1e3, 5, "ms");
  }
}
