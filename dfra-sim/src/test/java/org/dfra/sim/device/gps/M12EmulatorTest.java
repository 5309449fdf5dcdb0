package org.dfra.sim.device.gps;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.sim.device.Modules.await;

import java.io.IOException;
import java.net.InetAddress;
import java.net.Socket;
import java.time.Duration;
import java.time.Instant;
import java.util.HexFormat;
import org.dfra.geometry.GeoPosition;
import org.dfra.sim.device.SteppedClock;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The device over TCP, its clock stepped by the test. */
@Timeout(120)
class M12EmulatorTest {

  private static final byte[] HA_ONCE = HexFormat.of().parseHex("4040486100290d0a");
  private static final byte[] HA_EVERY_SECOND = HexFormat.of().parseHex("4040486101280d0a");
  private static final byte[] CJ = HexFormat.of().parseHex("4040436a290d0a");
  private static final M12EmulatorSettings SETTINGS =
      M12EmulatorSettings.at(new GeoPosition(52.9, 6.8, 55));

  private final SteppedClock clock = new SteppedClock(Instant.parse("2026-01-21T07:33:29Z"));
  private final M12Emulator emulator = new M12Emulator(SETTINGS, clock);

  @BeforeEach
  void start() throws IOException {
    emulator.start();
  }

  @AfterEach
  void close() {
    emulator.close();
  }

  @Test
  void sendsTheBytesOnlyAsTheClockAdvances() throws IOException {
    try (Socket client = connect()) {
      client.getOutputStream().write(HA_ONCE);
      assertThat(settled(client)).isZero(); // the clock does not advance
      await()
          .pollInterval(Duration.ofMillis(1))
          .until(
              () -> {
                clock.step(Duration.ofMillis(1));
                return client.getInputStream().available() > 0;
              });
      int begun = settled(client);
      clock.step(Duration.ofMillis(100));
      // 960 bytes/s are 96 in this time, and one that had partly gone out before
      assertThat(settled(client) - begun).isBetween(96, 97);
      clock.step(Duration.ofSeconds(1));
      assertThat(client.getInputStream().readNBytes(154)).startsWith("@@Ha".getBytes());
    }
  }

  @Test
  void keepsItsSettingsFromOneClientToTheNext() throws IOException {
    try (Socket first = connect()) {
      first.getOutputStream().write(HA_EVERY_SECOND);
      stepUntilBytesArrive(first);
    }
    try (Socket second = connect()) {
      stepUntilBytesArrive(second);
    }
  }

  @Test
  void aNewClientTakesThePlaceOfTheOld() throws IOException {
    try (Socket first = connect();
        Socket second = connect()) {
      assertThat(first.getInputStream().read()).isEqualTo(-1);
      second.getOutputStream().write(CJ);
      stepUntilBytesArrive(second);
    }
  }

  @Test
  void survivesAClientThatResets() throws IOException {
    Socket rude = connect();
    rude.getOutputStream().write(HA_EVERY_SECOND);
    rude.setSoLinger(true, 0);
    rude.close();
    try (Socket next = connect()) {
      next.getOutputStream().write(CJ);
      stepUntilBytesArrive(next);
    }
  }

  @Test
  void startAndCloseDoNothingTheSecondTime() throws IOException {
    int port = emulator.port();
    emulator.start();
    assertThat(emulator.port()).isEqualTo(port);
    assertThat(emulator.url()).isEqualTo("tcp://127.0.0.1:" + port);
    emulator.close();
    emulator.close();
    assertThatThrownBy(emulator::port).isInstanceOf(IllegalStateException.class);
    assertThatThrownBy(emulator::start).hasMessage("this emulator was closed; create a new one");
    assertThat(Thread.getAllStackTraces().keySet())
        .noneMatch(thread -> thread.getName().equals("m12 emulator " + port));
  }

  @Test
  void itsPortCanBeHadAgainAtOnce() throws IOException {
    int port = emulator.port();
    try (Socket client = connect()) {
      client.getOutputStream().write(CJ);
      stepUntilBytesArrive(client); // it is served, not merely waiting to be
      emulator.close();
      try (M12Emulator next = new M12Emulator(SETTINGS.withPort(port), clock)) {
        next.start();
        assertThat(next.port()).isEqualTo(port);
      }
    }
  }

  @Test
  void saysWhichPortItCannotHave() {
    int taken = emulator.port();
    try (M12Emulator second = new M12Emulator(SETTINGS.withPort(taken), clock)) {
      assertThatThrownBy(second::start)
          .isInstanceOf(IOException.class)
          .hasMessageStartingWith("port " + taken + " of the loopback interface cannot be opened (")
          .hasMessageEndingWith("choose another, or 0 for any free one");
    }
  }

  @Test
  void refusesSettingsThatCannotBe() {
    assertThatThrownBy(() -> SETTINGS.withPort(65536))
        .hasMessage("port 65536 is outside 0 to 65535");
    assertThatThrownBy(() -> SETTINGS.withBaud(0))
        .hasMessage("baud rate 0 is outside 1 to 4000000");
  }

  private Socket connect() throws IOException {
    return new Socket(InetAddress.getLoopbackAddress(), emulator.port());
  }

  /** Moves the clock on until bytes come. */
  private void stepUntilBytesArrive(Socket client) {
    await()
        .untilAsserted(
            () -> {
              clock.step(Duration.ofMillis(100));
              assertThat(client.getInputStream().available()).isPositive();
            });
  }

  /** How many bytes there are when the emulator has sent all that is due by the present time. */
  private int settled(Socket client) throws IOException {
    long before = clock.looks();
    await().until(() -> clock.looks() > before + 1);
    return client.getInputStream().available();
  }
}
