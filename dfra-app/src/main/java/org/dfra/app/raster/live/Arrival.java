package org.dfra.app.raster.live;

import java.time.Duration;
import org.dfra.app.demo.stage.Checks;
import org.dfra.core.config.RobotDescription;
import org.dfra.directory.ModuleDirectory;
import org.dfra.directory.ModuleListing;
import org.dfra.directory.ModuleQuery;
import org.dfra.module.Module;
import org.dfra.persona.ModuleAttributes;

/** When a robot that was started can begin. */
public final class Arrival {

  private static final Duration PATIENCE = Duration.ofSeconds(90);

  private Arrival() {}

  /**
   * Waits until all modules of a robot are found and ready.
   *
   * @throws Exception if they are not in time; the message names the robot
   */
  public static void await(ModuleDirectory directory, RobotDescription robot) throws Exception {
    int wanted = robot.modules().size();
    Checks.await(
        "that all " + wanted + " modules of " + robot.name() + " are found and ready",
        PATIENCE,
        () ->
            directory.find(ModuleQuery.of(Module.class).robot(robot.name())).stream()
                    .filter(Arrival::serves)
                    .count()
                >= wanted);
  }

  private static boolean serves(ModuleListing<?> listing) {
    return listing.attributes(ModuleAttributes.class).filter(a -> a.state().serves()).isPresent();
  }
}
