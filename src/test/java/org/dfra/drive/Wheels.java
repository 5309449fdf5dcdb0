package org.dfra.drive;

import static org.awaitility.Awaitility.await;

import java.io.IOException;
import java.time.Duration;
import java.time.Instant;
import java.time.InstantSource;
import java.util.Objects;
import org.dfra.core.time.StallProbe;
import org.dfra.sim.device.DeviceEmulator;
import org.dfra.sim.device.drive.RflexDevice;
import org.dfra.sim.physics.BatteryPhysics.Charge;
import org.dfra.sim.physics.IdealDrivetrain;
import org.jspecify.annotations.Nullable;

/**
 * An emulated rFLEX controller behind a TCP port, its wheels on blocks. Times are the controller's
 * own: when a command came to it, and since when the wheels stand by the laws of motion, whenever
 * anybody looks.
 */
public final class Wheels implements AutoCloseable {

  private static final Duration PATIENCE = Duration.ofSeconds(30);
  private static final Duration STANDING = Duration.ofMillis(500);
  private static final InstantSource CLOCK = InstantSource.system();

  private final StallProbe probe = StallProbe.start();

  private final IdealDrivetrain body = new IdealDrivetrain(CLOCK.instant());
  private final RflexDevice controller = new RflexDevice(body, time -> new Charge(25.2, 2, 0.75));
  private final DeviceEmulator emulator = new DeviceEmulator("rflex", 0, controller, CLOCK);

  public Wheels() throws IOException {
    emulator.start();
  }

  public String url() {
    return emulator.url();
  }

  /** Metres per second. */
  public double speed() {
    return body.travel(CLOCK.instant()).speed();
  }

  /** Metres forward since the beginning. */
  double distance() {
    return body.travel(CLOCK.instant()).distance();
  }

  /** When the last command came that was no halt. */
  Instant lastMotion() {
    return Objects.requireNonNull(controller.lastMotion(), "no command has come");
  }

  /** When the first order to halt came since; null while none has. */
  @Nullable Instant firstHalt() {
    return controller.firstHalt();
  }

  /** Waits until nobody has commanded for a second and the wheels stand. */
  public void assertTheyStoodWithinHalfASecondOfTheLastCommand() {
    await()
        .atMost(PATIENCE)
        .until(
            () -> CLOCK.instant().isAfter(lastMotion().plusSeconds(1)) && standingSince() != null);
    Duration stood =
        Duration.between(lastMotion(), Objects.requireNonNull(standingSince(), "they move"));
    System.out.printf("the wheels stood %.3f s after the last command%n", stood.toNanos() / 1e9);
    if (stood.isNegative()) {
      return; // the last command came too late to move them again
    }
    Duration ago = Duration.between(lastMotion(), CLOCK.instant());
    probe.past(ago, stood).requireWithin("from the last command to wheels that stand", STANDING);
  }

  /** Since when they stand; null while they turn. */
  public @Nullable Instant standingSince() {
    return body.stoppedSince(CLOCK.instant());
  }

  @Override
  public void close() {
    probe.close();
    emulator.close();
  }
}
