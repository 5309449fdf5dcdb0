package org.dfra.examples.mission.monitor;

import java.time.Duration;
import org.dfra.core.config.RobotDescription;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.examples.harness.DemoEnvironment;
import org.dfra.module.Module;
import org.dfra.persona.ModuleAttributes;
import org.dfra.report.progress.DemoAssertions;

/** Waits until a started robot is ready. */
public final class RobotStartup {

  private static final Duration PATIENCE = DemoEnvironment.PATIENCE;

  private RobotStartup() {}

  /**
   * Waits until all modules of a robot are found and ready.
   *
   * @throws Exception on a timeout; the message names the robot
   */
  public static void awaitReady(ModuleDirectory directory, RobotDescription robot)
      throws Exception {
    int wanted = robot.modules().size();
    DemoAssertions.await(
        "that all " + wanted + " modules of " + robot.name() + " are found and ready",
        PATIENCE,
        () ->
            directory.find(ModuleQuery.of(Module.class).robot(robot.name())).stream()
                    .filter(RobotStartup::serves)
                    .count()
                >= wanted);
  }

  private static boolean serves(ModuleListing<?> listing) {
    return listing.attributes(ModuleAttributes.class).filter(a -> a.state().serves()).isPresent();
  }
}
