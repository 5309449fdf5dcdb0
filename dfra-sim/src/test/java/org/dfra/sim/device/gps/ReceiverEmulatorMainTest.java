package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;

import java.io.BufferedReader;
import java.io.IOException;
import java.io.InputStream;
import java.net.InetAddress;
import java.net.ServerSocket;
import java.net.Socket;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.HexFormat;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.dfra.drivers.gps.m12.M12Parser;
import org.dfra.drivers.gps.m12.Position12Channels;
import org.dfra.sim.device.Programs;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The emulator as a process. */
@Timeout(180)
class ReceiverEmulatorMainTest {

  @Test
  void saysWhereItListensAndServesUntilItIsTerminated() throws Exception {
    Process process =
        launch("--latitude=52.5", "--longitude=-6.25", "--height=120", "--baud=115200");
    try {
      BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
      String line = out.readLine();
      assertThat(line).matches("listening on tcp://127\\.0\\.0\\.1:[0-9]+");
      int port = Integer.parseInt(line.substring(line.lastIndexOf(':') + 1));
      try (Socket client = new Socket(InetAddress.getLoopbackAddress(), port)) {
        client.getOutputStream().write(HexFormat.of().parseHex("4040486100290d0a"));
        byte[] frame = client.getInputStream().readNBytes(154);
        Position12Channels message = (Position12Channels) M12Parser.parse(frame).get(0);
        assertThat(message.position().latitude()).isEqualTo(52.5);
        assertThat(message.position().longitude()).isEqualTo(-6.25);
        assertThat(message.position().height()).isEqualTo(120);
      }
      assertThat(process.toHandle().destroy()).isTrue(); // SIGTERM, leaving its output open
      assertThat(process.waitFor(60, TimeUnit.SECONDS)).as("ended by SIGTERM").isTrue();
      assertThat(out.readLine()).as("a second line").isNull();
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void hasATerminalUntilItIsTerminated() throws Exception {
    Programs.require("socat");
    Process process = launch("--protocol=NMEA", "--baud=38400", "--terminal");
    try {
      BufferedReader out = process.inputReader(StandardCharsets.UTF_8);
      assertThat(out.readLine()).startsWith("listening on tcp://127.0.0.1:");
      String line = out.readLine();
      assertThat(line).startsWith("listening on serial:").endsWith("/nmea");
      Path port = Path.of(line.substring(line.indexOf(':') + 1));
      try (InputStream in = Files.newInputStream(port)) {
        assertThat(new String(in.readNBytes(7), StandardCharsets.US_ASCII)).isEqualTo("$GNRMC,");
      }
      assertThat(process.toHandle().destroy()).isTrue(); // SIGTERM, leaving its output open
      assertThat(process.waitFor(60, TimeUnit.SECONDS)).as("ended by SIGTERM").isTrue();
      assertThat(port.getParent()).doesNotExist();
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void sendsTheProtocolThatIsConfigured() throws Exception {
    Process process = launch("--protocol=NMEA", "--baud=38400");
    try {
      String line = process.inputReader(StandardCharsets.UTF_8).readLine();
      int port = Integer.parseInt(line.substring(line.lastIndexOf(':') + 1));
      try (Socket client = new Socket(InetAddress.getLoopbackAddress(), port)) {
        assertThat(new String(client.getInputStream().readNBytes(7), StandardCharsets.US_ASCII))
            .isEqualTo("$GNRMC,");
      }
    } finally {
      process.destroyForcibly();
    }
  }

  @Test
  void refusesAPlaceThatIsNotOnEarth() throws Exception {
    Process process = launch("--latitude=91");
    String errors = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
    assertThat(errors).contains("is outside").contains("latitude 91.0");
    assertThat(process.waitFor()).isEqualTo(2);
  }

  @Test
  void saysThatItsPortIsTaken() throws Exception {
    try (ServerSocket taken = new ServerSocket(0, 1, InetAddress.getLoopbackAddress())) {
      Process process = launch("--port=" + taken.getLocalPort());
      String errors = new String(process.getErrorStream().readAllBytes(), StandardCharsets.UTF_8);
      assertThat(errors).contains("port " + taken.getLocalPort() + " of the loopback interface");
      assertThat(process.waitFor()).isEqualTo(1);
    }
  }

  private static Process launch(String... options) throws IOException {
    List<String> command =
        new ArrayList<>(
            List.of(
                System.getProperty("java.home") + "/bin/java",
                "-cp",
                System.getProperty("java.class.path"),
                ReceiverEmulatorMain.class.getName()));
    command.addAll(List.of(options));
    return new ProcessBuilder(command).start();
  }
}
