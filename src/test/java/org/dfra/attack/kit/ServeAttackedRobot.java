package org.dfra.attack.kit;

import java.io.BufferedReader;
import java.io.InputStreamReader;
import java.io.PrintStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.rmi.RemoteException;
import java.time.Duration;
import java.util.List;
import org.dfra.benchmarks.task.Task;
import org.dfra.drive.Wheels;
import org.dfra.flow.effector.DriveEffector;
import org.dfra.lifecycle.Readiness;
import org.dfra.river.bootstrap.EmbeddedRobot;
import org.dfra.river.lookup.JiniModuleDirectory;

/**
 * Robot eta in a process of its own, for a computer of its own. Each line of its input is answered
 * by {@code state LATCHED MAX_SPEED}: whether its drive is stopped for an emergency, and the
 * drive's parameter {@code max_speed} in m/s.
 */
public final class ServeAttackedRobot implements Task {

  private static final Duration PATIENCE = Duration.ofSeconds(60);

  /** As every task is made. */
  public ServeAttackedRobot() {}

  /**
   * Arguments: the address to serve at, and a folder for its description. Prints {@code ready
   * PORT}, the port of its registrar, when the drive works. Ends with its input.
   */
  @Override
  public void run(String[] args, PrintStream out) throws Exception {
    try (Wheels wheels = new Wheels();
        EmbeddedRobot robot = AttackedRobot.of(Path.of(args[1]), args[0], "", wheels)) {
      robot.start();
      try (JiniModuleDirectory directory =
          new JiniModuleDirectory(args[0], List.of(), List.of(robot.registrar().locator()))) {
        DriveEffector drive = directory.find(DriveEffector.class, PATIENCE).orElseThrow();
        Readiness readiness = drive.awaitReadiness(PATIENCE);
        if (readiness != Readiness.READY) {
          throw new IllegalStateException("the drive is " + readiness);
        }
        out.println("ready " + robot.registrar().port());
        answer(drive, out);
      }
    }
  }

  private static void answer(DriveEffector drive, PrintStream out) throws Exception {
    BufferedReader in =
        new BufferedReader(new InputStreamReader(System.in, StandardCharsets.UTF_8));
    while (in.readLine() != null) {
      out.println("state " + drive.emergencyStopState().latched() + " " + maxSpeed(drive));
    }
  }

  private static double maxSpeed(DriveEffector drive) throws RemoteException {
    return drive.parameters().stream()
        .filter(each -> each.name().equals("max_speed"))
        .mapToDouble(each -> Double.parseDouble(each.value()))
        .findFirst()
        .orElseThrow();
  }
}
