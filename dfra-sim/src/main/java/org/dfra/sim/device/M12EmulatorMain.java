package org.dfra.sim.device;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Clock;
import java.util.concurrent.Callable;
import org.dfra.geometry.GeoPosition;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * An emulated M12+ as a process of its own. Prints {@code listening on tcp://127.0.0.1:PORT} when
 * it is ready, and runs until it is terminated. Exit status 2 when an option is wrong, 1 when the
 * port cannot be had.
 */
@Command(
    name = "m12-emulator",
    mixinStandardHelpOptions = true,
    description = "A Motorola Oncore M12+ GPS receiver that does not exist, on a TCP port.")
public final class M12EmulatorMain implements Callable<Integer> {

  @Option(
      names = "--port",
      defaultValue = "0",
      description = "TCP port on the loopback interface; 0 is any free one. Default: 0.")
  private int port;

  @Option(
      names = "--latitude",
      defaultValue = "48.0",
      description = "Degrees, north is +. Default: ${DEFAULT-VALUE}.")
  private double latitude;

  @Option(
      names = "--longitude",
      defaultValue = "11.0",
      description = "Degrees, east is +. Default: ${DEFAULT-VALUE}.")
  private double longitude;

  @Option(
      names = "--height",
      defaultValue = "500",
      description = "Metres above the WGS84 ellipsoid. Default: ${DEFAULT-VALUE}.")
  private double height;

  @Option(
      names = "--baud",
      defaultValue = "9600",
      description = "Bits per second of the line. Default: ${DEFAULT-VALUE}.")
  private int baud;

  @Spec
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private CommandSpec spec;

  private M12EmulatorMain() {}

  /** Runs it. */
  public static void main(String[] arguments) {
    System.exit(new CommandLine(new M12EmulatorMain()).execute(arguments));
  }

  @Override
  public Integer call() throws InterruptedException {
    PrintWriter out = spec.commandLine().getOut();
    try (M12Emulator emulator = new M12Emulator(settings(), Clock.systemUTC())) {
      emulator.start();
      Runtime.getRuntime().addShutdownHook(new Thread(emulator::close, "m12 emulator end"));
      out.println("listening on " + emulator.url());
      out.flush();
      emulator.await();
      return 0;
    } catch (IOException e) {
      spec.commandLine().getErr().println(e.getMessage());
      return 1;
    }
  }

  private M12Settings settings() {
    try {
      return M12Settings.at(new GeoPosition(latitude, longitude, height))
          .withPort(port)
          .withBaud(baud);
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
    }
  }
}
