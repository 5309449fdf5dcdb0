package org.dfra.sim.device;

import static java.nio.charset.StandardCharsets.US_ASCII;
import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.sim.device.Modules.await;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.time.Clock;
import java.time.Duration;
import java.util.List;
import org.dfra.drivers.link.LinkAddress;
import org.dfra.drivers.link.SerialLink;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

@Timeout(180)
class PseudoTerminalTest {

  private final EchoDevice device = new EchoDevice(0);
  private final DeviceEmulator emulator = new DeviceEmulator("echo", 0, device, Clock.systemUTC());
  private final PseudoTerminal terminal = new PseudoTerminal("ttyEcho", emulator);

  @BeforeEach
  void start() throws IOException {
    emulator.start();
  }

  @AfterEach
  void end() {
    terminal.close();
    emulator.close();
  }

  private Path port() {
    return Path.of(terminal.url().substring("serial:".length()));
  }

  private static String exchange(SerialLink link, String text) throws IOException {
    link.write(text.getBytes(US_ASCII));
    byte[] buffer = new byte[text.length()];
    int filled = 0;
    for (int i = 0; i < 200 && filled < buffer.length; i++) { // 20 s
      int count = link.read(buffer, filled, buffer.length - filled, Duration.ofMillis(100));
      assertThat(count).as("the port is lost").isNotNegative();
      filled += count;
    }
    return new String(buffer, 0, filled, US_ASCII);
  }

  @Test
  void isASerialPortOfTheDevice() throws IOException {
    Programs.require("socat");
    terminal.start();
    terminal.start();
    try (SerialLink link = LinkAddress.open(terminal.url() + "?baud=115200")) {
      assertThat(exchange(link, "hello\r\n\003\004")).isEqualTo("hello\r\n\003\004");
    }
  }

  @Test
  void isGoneWhileTheCableIsPulledAndComesBackUnderItsName() throws IOException {
    Programs.require("socat");
    terminal.start();
    try (SerialLink link = LinkAddress.open(terminal.url())) {
      assertThat(exchange(link, "a")).isEqualTo("a");
      emulator.cable().unplug();
      await().until(() -> link.read(new byte[1], 0, 1, Duration.ofMillis(100)) < 0);
    }
    await().until(() -> !Files.exists(port()));
    emulator.cable().restore();
    await().until(() -> Files.exists(port()));
    try (SerialLink link = LinkAddress.open(terminal.url())) {
      assertThat(exchange(link, "b")).isEqualTo("b");
    }
  }

  @Test
  void leavesNothingBehind() throws IOException {
    Programs.require("socat");
    terminal.start();
    Path folder = port().getParent();
    assertThat(socats(folder)).hasSize(1);
    terminal.close();
    terminal.close();
    assertThat(folder).doesNotExist();
    assertThat(socats(folder)).isEmpty();
    assertThatThrownBy(terminal::start).hasMessage("this terminal was closed; create a new one");
  }

  private static List<ProcessHandle> socats(Path folder) {
    return ProcessHandle.current()
        .children()
        .filter(each -> each.info().commandLine().orElse("").contains(folder.toString()))
        .toList();
  }

  @Test
  void saysThatSocatIsMissing() {
    try (PseudoTerminal without = new PseudoTerminal("ttyEcho", emulator, "/nowhere")) {
      assertThatThrownBy(without::start)
          .isInstanceOf(IOException.class)
          .hasMessage(
              "a pseudo-terminal needs the program socat, which was not found in PATH (/nowhere);"
                  + " install it, or use the link "
                  + emulator.url());
      assertThatThrownBy(without::url).hasMessageContaining("start the terminal first");
    }
  }
}
