package org.dfra.drivers.drive.rflex;

import static org.assertj.core.api.Assertions.assertThat;
import static org.assertj.core.api.Assertions.assertThatThrownBy;
import static org.dfra.drivers.fixture.Modules.await;

import java.io.IOException;
import java.time.Duration;
import java.time.InstantSource;
import java.util.HexFormat;
import java.util.List;
import java.util.Map;
import java.util.concurrent.Callable;
import java.util.concurrent.CopyOnWriteArrayList;
import org.dfra.core.config.Parameters;
import org.dfra.core.module.ModuleContext;
import org.dfra.drivers.fixture.ScriptedLink;
import org.dfra.drivers.fixture.StepTicker;
import org.dfra.flow.effector.CommandKey;
import org.dfra.flow.effector.DriveCommand.Brake;
import org.dfra.flow.effector.DriveCommand.Velocity;
import org.dfra.lifecycle.Readiness;
import org.junit.jupiter.api.AfterEach;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.Timeout;

/** The driver with a controller that the test plays, frame by frame. */
@Timeout(120)
class RflexDriveImplTest {

  private static final HexFormat HEX = HexFormat.of().withUpperCase();

  /** Along x at rest, and at half a metre per second; about z at rest. */
  private static final String STANDING = report("00", "00000000");

  private static final String MOVING = report("00", "0000AAD3");
  private static final String NOT_TURNING = report("01", "00000000");

  private final StepTicker ticker = new StepTicker(false);
  private final List<ScriptedLink> links = new CopyOnWriteArrayList<>();
  private final RflexDriveImpl drive =
      new RflexDriveImpl(
          new ModuleContext(
              "atrv1",
              "drive",
              Parameters.of(
                  "atrv1/drive",
                  Map.of("link", "tcp://192.0.2.1:4001", "reopen_initial_delay", "0.01")),
              InstantSource.system()),
          ticker,
          this::open);

  private ScriptedLink open() throws IOException {
    ScriptedLink link = new ScriptedLink("tcp://192.0.2.1:4001");
    links.add(link);
    return link;
  }

  private static String report(String axis, String velocity) {
    return framed(
        "0200211900000000" + "00000000" + axis + "00000000" + velocity + "0000000000000000");
  }

  private static String status(boolean brake) {
    return framed("01000109" + "00000000" + "00000960" + (brake ? "01" : "00"));
  }

  private static String framed(String hex) {
    byte sum = 0;
    for (byte each : HEX.parseHex(hex)) {
      sum ^= each;
    }
    return "1B02" + hex + HEX.toHexDigits(sum) + "1B03";
  }

  private ScriptedLink link() {
    return links.get(links.size() - 1);
  }

  private void say(String... frames) {
    for (String frame : frames) {
      link().say(HEX.parseHex(frame));
    }
  }

  /** The velocities along x that were sent, each in counts per second. */
  private List<Integer> sentVelocities() {
    return link().written().stream()
        .map(HEX::formatHex)
        .filter(each -> each.startsWith("1B0202000" + "70E00"))
        .map(each -> Integer.parseInt(each.substring(14, 22), 16))
        .toList();
  }

  @BeforeEach
  void start() {
    drive.start();
    await().until(() -> !links.isEmpty());
  }

  @AfterEach
  void close() {
    drive.close();
  }

  /** The controller repeats these frames, and time advances, until this is true. */
  private void reporting(Callable<Boolean> enough, String... frames) {
    await()
        .until(
            () -> {
              say(frames);
              ticker.step(Duration.ofMillis(10));
              return enough.call();
            });
  }

  private void serve(boolean brake) {
    reporting(() -> drive.readiness().serves(), STANDING, NOT_TURNING, status(brake));
  }

  @Test
  void haltsTheWheelsFirstAndAsksForReportsAndStatus() {
    reporting(() -> sentVelocities().size() >= 3, STANDING, NOT_TURNING);
    assertThat(sentVelocities()).as("1 is sent instead of 0").containsOnly(1);
    List<String> requests = List.of("1B0202002208000186A0000000030C1B03", "1B0201000100001B03");
    reporting(
        () -> link().written().stream().map(HEX::formatHex).toList().containsAll(requests),
        STANDING,
        NOT_TURNING);
    assertThat(link().written().stream().map(HEX::formatHex).limit(2))
        .as("halts go first")
        .allMatch(each -> each.startsWith("1B02020007"));
    assertThat(drive.readiness()).isEqualTo(Readiness.INITIALIZING);
  }

  @Test
  void servesOnceBothAxesAndTheBrakeAreKnown() throws Exception {
    say(STANDING, NOT_TURNING);
    CommandKey key = drive.acquireCommandLease(Duration.ofSeconds(30)).key();
    assertThatThrownBy(() -> drive.execute(key, new Brake(true)))
        .hasMessageStartingWith(
            "atrv1/drive is INITIALIZING: it cannot execute Brake[engaged=true] now");
    serve(true);
    assertThat(drive.driveState().parkingBrakeEngaged()).isTrue();
    assertThatThrownBy(() -> drive.execute(key, new Velocity(1, 0)))
        .hasMessageContaining("has its brake set");
  }

  @Test
  void sendsAVelocityOnceAndAHaltUntilTheWheelsAreReportedStopped() throws Exception {
    serve(false);
    CommandKey key = drive.acquireCommandLease(Duration.ofSeconds(30)).key();
    reporting(() -> sentVelocities().size() >= 3, STANDING, NOT_TURNING);
    int before = sentVelocities().size();
    drive.execute(key, new Velocity(0.5, 0));
    // No command follows, so it is halted, which this controller does not execute.
    reporting(() -> sentVelocities().size() >= before + 1 + 3 * 3, MOVING, NOT_TURNING);
    assertThat(sentVelocities().subList(before, sentVelocities().size()))
        .as("one velocity, then halts")
        .startsWith(43_731, 1, 1, 1, 1)
        .containsOnlyOnce(43_731);
    assertThat(drive.driveState().commandTimeouts()).isEqualTo(1);
  }

  @Test
  void whatWasCommandedBeforeTheLinkWasLostIsNotSentAfterIt() throws Exception {
    serve(false);
    CommandKey key = drive.acquireCommandLease(Duration.ofSeconds(30)).key();
    drive.execute(key, new Velocity(0.5, 0));
    link().unplug();
    reporting(() -> links.size() >= 2);
    reporting(() -> sentVelocities().size() >= 3, STANDING, NOT_TURNING);
    assertThat(sentVelocities()).containsOnly(1);
    assertThat(drive.driveState().velocity()).isEqualTo(Velocity.ZERO);
  }
}
