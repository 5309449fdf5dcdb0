package org.dfra.attack.stop;

import java.nio.file.Files;
import java.nio.file.Path;
import org.dfra.core.time.StallProbe;
import org.dfra.drive.WheeledRobot;
import org.dfra.drive.WheeledRobot.CommandResult;

/**
 * The robot eta, whose registrar takes fakes of its drive, and another computer that stops it.
 *
 * @param elsewhere the folder of that computer, which knows no robot
 * @param probe runs while the robot does
 */
record RobotBesideFakes(WheeledRobot robot, FalseDrives fakes, Path elsewhere, StallProbe probe)
    implements AutoCloseable {

  /**
   * Brings it up without any fake, or leaves nothing behind.
   *
   * @param folder of this test alone
   */
  static RobotBesideFakes start(Path folder) throws Exception {
    Path elsewhere = Files.createDirectories(folder.resolve("elsewhere"));
    WheeledRobot robot = WheeledRobot.start(folder, "drive");
    try {
      FalseDrives fakes = new FalseDrives(robot.locator());
      return new RobotBesideFakes(robot, fakes, elsewhere, StallProbe.start());
    } catch (Exception e) {
      robot.close();
      throw e;
    }
  }

  /** What {@code ./dfra stop} answers on the other computer. */
  CommandResult stop(String... words) throws Exception {
    return robot.stopFromElsewhere(elsewhere, words);
  }

  @Override
  public void close() throws Exception {
    try {
      robot.close();
    } finally {
      fakes.close();
      probe.close();
    }
  }
}
