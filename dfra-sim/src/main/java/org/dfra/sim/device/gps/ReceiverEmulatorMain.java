package org.dfra.sim.device.gps;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Clock;
import java.time.Duration;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.PseudoTerminal;
import org.dfra.sim.device.SerialDevice;
import org.dfra.sim.device.gps.M12EmulatorSettings.M12EmulatorOptions;
import org.dfra.text.PrintableText;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * Runs an emulated GPS receiver as a process of its own. Prints {@code listening on
 * tcp://127.0.0.1:PORT} when it is ready, and {@code listening on serial:FILE} where a terminal is
 * requested, and runs until it is terminated. Exit status 2 when an option is wrong, 1 when port or
 * terminal cannot be opened.
 */
@Command(
    name = "receiver-emulator",
    mixinStandardHelpOptions = true,
    description = "Emulates a GPS receiver on a TCP port.")
public final class ReceiverEmulatorMain implements Callable<Integer> {

  /** The receiver's protocol. */
  enum Protocol {
    /** Motorola's binary protocol. */
    M12,
    /** NMEA 0183. */
    NMEA,
    /** u-blox's binary protocol. */
    UBX,
    /** gpsd's JSON protocol. */
    GPSD
  }

  @Option(
      names = "--protocol",
      defaultValue = "M12",
      description =
          "Protocol of the receiver: ${COMPLETION-CANDIDATES}. Default: ${DEFAULT-VALUE}.")
  private Protocol protocol = Protocol.M12;

  @Option(
      names = "--port",
      defaultValue = "0",
      description = "TCP port on the loopback interface; 0 chooses a free one. Default: 0.")
  private int port;

  @Option(
      names = "--latitude",
      defaultValue = "48.0",
      description = "Latitude in degrees, north is +. Default: ${DEFAULT-VALUE}.")
  private double latitude;

  @Option(
      names = "--longitude",
      defaultValue = "11.0",
      description = "Longitude in degrees, east is +. Default: ${DEFAULT-VALUE}.")
  private double longitude;

  @Option(
      names = "--height",
      defaultValue = "500",
      description = "Height in metres above the WGS84 ellipsoid. Default: ${DEFAULT-VALUE}.")
  private double height;

  @Option(
      names = "--baud",
      defaultValue = "9600",
      description = "Baud rate of the serial line. Default: ${DEFAULT-VALUE}.")
  private int baud;

  @Option(
      names = "--channels",
      defaultValue = "12",
      description = "M12 only: number of channels, 8 or 12. Default: ${DEFAULT-VALUE}.")
  private int channels;

  @Option(
      names = "--utc-after",
      defaultValue = "0",
      description =
          "M12 only: seconds until it knows the offset of UTC, as after a start without an"
              + " almanac. Default: ${DEFAULT-VALUE}.")
  private int utcAfter;

  @Option(
      names = "--terminal",
      description = "Also create a pseudo-terminal, which drivers can use as a serial port.")
  private boolean terminal;

  @Spec
  @SuppressWarnings("NullAway.Init") // picocli sets it before it calls
  private CommandSpec spec;

  private ReceiverEmulatorMain() {}

  /** Runs it. */
  public static void main(String[] arguments) {
    System.exit(new CommandLine(new ReceiverEmulatorMain()).execute(arguments));
  }

  @Override
  public Integer call() throws InterruptedException {
    PrintWriter out = spec.commandLine().getOut();
    try (DeviceEmulator emulator = emulator()) {
      emulator.start();
      PseudoTerminal port = new PseudoTerminal(word(), emulator);
      Runtime.getRuntime().addShutdownHook(new Thread(() -> end(port, emulator), "emulator end"));
      out.println("listening on " + emulator.url());
      if (terminal) {
        port.start();
        out.println("listening on " + port.url());
      }
      out.flush();
      emulator.await();
      return 0;
    } catch (IOException e) {
      spec.commandLine().getErr().println(PrintableText.line(String.valueOf(e.getMessage())));
      return 1;
    }
  }

  private static void end(PseudoTerminal port, DeviceEmulator emulator) {
    port.close();
    emulator.close();
  }

  private String word() {
    return protocol.name().toLowerCase(Locale.ROOT);
  }

  private DeviceEmulator emulator() {
    try {
      AntennaTrajectory path =
          AntennaTrajectory.fixed(new GeoPosition(latitude, longitude, height));
      SerialDevice device =
          switch (protocol) {
            case M12 ->
                new M12Device(
                    path,
                    baud,
                    Duration.ZERO,
                    new M12EmulatorOptions(channels, Duration.ofSeconds(utcAfter)));
            case NMEA -> new NmeaDevice(path, baud, Duration.ZERO);
            case UBX -> new UbxDevice(path, baud, Duration.ZERO);
            case GPSD -> new GpsdDevice(path, baud, Duration.ZERO);
          };
      return new DeviceEmulator(word(), port, device, Clock.systemUTC());
    } catch (IllegalArgumentException e) {
      throw new ParameterException(spec.commandLine(), String.valueOf(e.getMessage()), e);
    }
  }
}
